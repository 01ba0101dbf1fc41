"""Files that scenes name: pictures, fonts, density files."""

from __future__ import annotations

from pathlib import Path
from typing import Final

from minipov.interpreter.constructs.gamma import working_gamma
from minipov.interpreter.context import Context
from minipov.interpreter.errors import SdlError
from minipov.interpreter.reader import ItemReader
from minipov.tracer.image import Image, ImagePurpose
from minipov.tracer.settings import Gamma

EXTENSIONS: Final[dict[str, tuple[str, ...]]] = {
    "bmp": ("", ".bmp", ".BMP"),
    "exr": ("", ".exr", ".EXR"),
    "gif": ("", ".gif", ".GIF"),
    "hdr": ("", ".hdr", ".HDR"),
    "iff": ("", ".iff", ".IFF"),
    "jpeg": ("", ".jpg", ".jpeg", ".JPG", ".JPEG"),
    "pgm": ("", ".pgm", ".PGM"),
    "png": ("", ".png", ".PNG"),
    "pot": ("", ".pot", ".POT"),
    "ppm": ("", ".ppm", ".PPM"),
    "sys": ("", ".bmp", ".BMP"),
    "tga": ("", ".tga", ".TGA"),
    "tiff": ("", ".tif", ".tiff", ".TIF", ".TIFF"),
    "ttf": ("", ".ttf", ".ttc", ".TTF", ".TTC"),
    "df3": ("", ".df3", ".DF3"),
}
IMAGE_TYPES: Final = tuple(kind for kind in EXTENSIONS if kind not in ("ttf", "df3"))
ANY_IMAGE: Final = tuple(dict.fromkeys(extension for kind in IMAGE_TYPES for extension in EXTENSIONS[kind]))


def find(reader: ItemReader, context: Context, kind: str) -> Path:
    """The file that the string here names, searched as includes are; ``kind`` "" tries all kinds of images."""
    place = reader.place
    name = reader.string()
    path = context.find_file(name, EXTENSIONS[kind] if kind else ANY_IMAGE)
    if path is None:
        raise SdlError(
            f"{reader.name}: cannot find the file '{name}'",
            place,
            "files are looked for beside the scene and in the library paths (+L)",
        )
    return path


def image(reader: ItemReader, context: Context, path: Path, kind: str, *, gamma: Gamma, purpose: ImagePurpose) -> Image:
    """The picture at ``path``."""
    load = context.options.load_image
    if load is None:
        raise SdlError(f"{reader.name}: this run has no reader of image files", reader.place)
    try:
        working, version = working_gamma(context), context.version
        return load(path, kind, gamma=gamma, purpose=purpose, working=working, version=version)
    except OSError as error:
        raise SdlError(f"{reader.name}: cannot read '{path}': {error}", reader.place) from error
