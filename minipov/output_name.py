"""What to write, and under which name: ``+Oname +FN16 +UA``, ``Output_File_Name=folder/``.

As POV-Ray does: without a name the picture goes beside the scene; a folder (or a name that ends in a slash) gets the
scene's name; a missing extension is added; frames put their number before it. The extension tells the type where no
option does, which POV-Ray would not do.
"""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from minipov.dither import DITHER_METHODS
from minipov.frames import Frame
from minipov.gamma import parse_gamma
from minipov.image_format import EXTENSIONS, FileFormat, FileKind
from minipov.options import CommandLine, UsageError

_LETTERS: dict[str, FileKind] = {
    "N": "png",
    "T": "tga",
    "C": "tga_rle",
    "P": "ppm",
    "B": "bmp",
    "J": "jpeg",
    "E": "exr",
    "H": "hdr",
    "S": "bmp",
}
_BY_EXTENSION: dict[str, FileKind] = {extension: kind for kind, extension in reversed(EXTENSIONS.items())}
_BY_EXTENSION |= {".jpeg": "jpeg", ".pgm": "ppm", ".pnm": "ppm"}


def file_format(command: CommandLine) -> FileFormat:
    """Return how the picture is to be stored.

    Raises:
        UsageError: a gamma or a number of bits that cannot be.
    """
    letter = command.text("Output_File_Type")
    extension = Path(command.text("Output_File_Name")).suffix.lower()
    kind: FileKind = _LETTERS[letter] if letter else _BY_EXTENSION.get(extension, "png")
    gray = command.flag("Grayscale_Output")
    bits = 16 if gray else command.integer("Bits_Per_Color")
    if not 1 <= bits <= 16:
        raise UsageError(f"Bits_Per_Color={bits}: 1 to 16 are possible")
    quality = command.integer("Compression")
    try:
        gamma = parse_gamma(command.text("File_Gamma"))
    except ValueError:
        raise UsageError(f"File_Gamma={command.text('File_Gamma')}: expected sRGB or a number above 0") from None
    return FileFormat(
        kind,
        bits,
        gamma,
        alpha=command.flag("Output_Alpha"),
        gray=gray,
        quality=85 if quality in (0, 1) else min(max(quality, 2), 100),
        dither=_dither_method(command) if command.flag("Dither") else "",
    )


def _dither_method(command: CommandLine) -> str:
    method = command.text("Dither_Method").upper()
    if method not in DITHER_METHODS:
        raise UsageError(f"Dither_Method={method}: possible are {', '.join(DITHER_METHODS)}")
    return method


def output_path(command: CommandLine, scene: Path, frame: Frame, kind: FileKind) -> Path | Literal["-"]:
    """Return the file to write for ``frame`` of ``scene``; "-" is standard output."""
    name = command.text("Output_File_Name")
    if name == "-":
        return "-"
    stem = "stdin" if str(scene) == "-" else scene.stem
    if not name:
        path = scene.with_name(stem)
    elif name.endswith("/") or Path(name).is_dir():
        path = Path(name) / stem
    else:
        path = Path(name)
    extension = path.suffix if path.suffix.lower() in _BY_EXTENSION else ""
    base = path.name.removesuffix(extension)
    return path.with_name(base + frame.suffix + (extension or EXTENSIONS[kind]))
