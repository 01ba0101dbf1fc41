"""Reading the image files a scene names: ``image_map { png "a.png" gamma srgb }``, height fields, bump maps.

Which numbers POV-Ray takes from a file was measured by ``function { pigment { image_map { … } } }`` for each format,
bit depth and ``#version``; the tables below say the outcome.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import OpenImageIO as oiio
from numpy.typing import NDArray
from PIL import Image as Pillow, UnidentifiedImageError

from minipov.gamma import Floats, convert
from minipov.tracer.image import Image, ImagePurpose
from minipov.tracer.settings import Gamma

_PALETTE_FORMATS = frozenset({"png", "gif", "bmp", "tga"})
_SRGB_FORMATS = frozenset({"png", "gif", "bmp", "tga", "jpeg"})
"""Formats taken as sRGB; PPM, PGM and TIFF are not converted at all, EXR and HDR are linear."""
_LINEAR_FORMATS = frozenset({"openexr", "hdr"})
_ASSOCIATED_FORMATS = frozenset({"openexr"})
_OIIO_NAMES = {"targa": "tga"}


@dataclass(frozen=True, slots=True, eq=False)
class _Stored:
    """What a file holds: ``channels`` (height, width, 1 to 4) scaled to 0..1, and the ``curve`` that the file names."""

    channels: Floats
    kind: str
    integer_bits: int
    curve: Gamma = None
    index: NDArray[np.uint16] | None = None
    palette_size: int = 0


def load_image(
    path: Path,
    kind: str = "",
    *,
    gamma: Gamma = None,
    purpose: ImagePurpose = "color",
    working: Gamma = 1.0,
    version: float = 3.7,
) -> Image:
    """Return the picture in ``path`` with its colours in the ``working`` space.

    ``gamma`` is what the scene says the file uses; where it says nothing (None) a picture for the ``purpose`` of colour
    has its format's, other pictures' numbers are taken as they are; before ``version`` 3.7 only a curve named in the
    file counts. ``kind``, SDL's file type, is checked by content.

    Raises:
        OSError: the file is missing, damaged or of an unknown format.
    """
    stored = _read_palette(path) or _read_channels(path)
    if kind == "pot" and purpose == "heights" and stored.index is not None:
        stored = _joined_halves(stored.index)
    channels = stored.channels
    count = channels.shape[2]
    alpha = channels[..., -1] if count in (2, 4) else None
    color = channels[..., :1] if count < 3 else channels[..., :3]
    source = gamma if gamma is not None else (_default_curve(stored, version) if purpose == "color" else None)
    color = convert(color, source, working)
    if alpha is not None and stored.kind in _ASSOCIATED_FORMATS:
        color = np.divide(color, alpha[..., None], out=np.zeros_like(color), where=alpha[..., None] != 0)
    if count == 1 and stored.kind == "png" and stored.integer_bits == 8 and stored.index is None:
        color = _grey_bytes(color)
    return Image(
        color=np.ascontiguousarray(np.broadcast_to(color, (*color.shape[:2], 3)), np.float32),
        alpha=None if alpha is None else np.ascontiguousarray(alpha, np.float32),
        index=stored.index,
        palette_size=stored.palette_size,
        gray=count < 3,
    )


def _joined_halves(index: NDArray[np.uint16]) -> _Stored:
    """The heights of a POT file, a GIF twice as wide: high bytes on the left, low bytes on the right."""
    width = index.shape[1] // 2
    steps = index[:, :width].astype(np.float64) * 256.0 + index[:, width : 2 * width]
    return _Stored(steps[..., None] / 65535.0, "pot", 16, None)


def _default_curve(stored: _Stored, version: float) -> Gamma:
    if stored.kind in _LINEAR_FORMATS:
        return 1.0
    if stored.kind == "png" and stored.curve is not None:
        return stored.curve
    return "srgb" if version >= 3.7 and stored.kind in _SRGB_FORMATS else None


def _grey_bytes(grey: Floats) -> Floats:
    """8-bit grey PNG files end up as bytes again after the conversion, through a weighted sum in single precision."""
    single = grey.astype(np.float32)
    weighted = np.float32(0.297) * single + np.float32(0.589) * single + np.float32(0.114) * single
    return np.asarray(np.trunc(weighted * np.float32(255)), np.float64) / 255


def _read_palette(path: Path) -> _Stored | None:
    """Read a file of palette indices, or return None for any other; OpenImageIO would hide the indices."""
    try:
        with Pillow.open(path) as picture:
            kind = (picture.format or "").lower()
            # Pillow shows a GIF whose palette is a ramp of grey as grey.
            grey = kind == "gif" and picture.mode == "L"
            if not (grey or (picture.mode == "P" and kind in _PALETTE_FORMATS)):
                return None
            interlaced = kind == "gif" and _is_interlaced(picture)
            index = np.asarray(picture, np.uint16)
            indexed = picture.convert("P") if grey else picture
            names = indexed.palette.mode if indexed.palette else "RGB"
            palette = np.array(indexed.getpalette(names) or [], np.float64).reshape(-1, len(names))[:, :3] / 255
            clear = picture.info.get("transparency")
            curve = _png_curve(picture.info)
    except (UnidentifiedImageError, SyntaxError, ValueError):
        return None
    if interlaced:
        # POV-Ray shows the rows of an interlaced GIF in the order of the file.
        passes = ((0, 8), (4, 8), (2, 4), (1, 2))
        index = index[[row for start, step in passes for row in range(start, len(index), step)]]
    size = max(len(palette), int(index.max(initial=0)) + 1)
    palette = np.pad(palette, ((0, size - len(palette)), (0, 0)))
    if clear is not None:
        opacity = np.full((size, 1), 1.0)
        if isinstance(clear, bytes):
            opacity[: len(clear), 0] = np.frombuffer(clear, np.uint8)[:size] / 255
        else:
            opacity[int(clear)] = 0.0
        palette = np.hstack([palette, opacity])
    return _Stored(palette[index], kind, 8, curve, index, size)


def _is_interlaced(picture: Pillow.Image) -> bool:
    return any(isinstance(args, tuple) and bool(args[1]) for _, _, _, args in getattr(picture, "tile", ()))


def _png_curve(info: dict[str | tuple[int, int], object]) -> Gamma:
    if "srgb" in info:
        return "srgb"
    named = info.get("gamma")
    return 1 / named if isinstance(named, float) and named > 0 else None


def _read_channels(path: Path) -> _Stored:
    config = oiio.ImageSpec()
    config.attribute("oiio:UnassociatedAlpha", 1)
    opened = oiio.ImageInput.open(str(path), config)
    if opened is None:
        if not path.is_file():
            raise FileNotFoundError(f"no such file: {path}")
        raise OSError(f"cannot read {path}: {oiio.geterror()}")
    try:
        kind, spec = opened.format_name(), opened.spec()
        # Whole numbers are scaled here: a division rounds otherwise than the library's multiplication.
        stored_type = str(spec.format)
        scale = {"uint8": 255.0, "uint16": 65535.0}.get(stored_type, 1.0)
        kind_read = stored_type if scale > 1.0 else "float"
        pixels = opened.read_image(0, 0, 0, min(spec.nchannels, 4), kind_read)
        if pixels is None:
            raise OSError(f"cannot read {path}: {opened.geterror()}")
    finally:
        opened.close()
    bits = {"uint8": 8, "uint16": 16}.get(stored_type, 0)
    channels = np.asarray(pixels, np.float64).reshape(spec.height, spec.width, -1) / scale
    if kind == "hdr":
        channels = _middle_of_mantissa(channels)
    return _Stored(channels, _OIIO_NAMES.get(kind, kind), bits, _pillow_curve(path) if kind == "png" else None)


def _middle_of_mantissa(rgb: Floats) -> Floats:
    """Radiance pixels share an exponent; POV-Ray reads each 8-bit mantissa as the middle of its step."""
    largest = rgb.max(axis=2, keepdims=True)
    _, exponent = np.frexp(largest)
    return np.where(largest > 0, rgb + np.ldexp(0.5 / 256, exponent), rgb)


def _pillow_curve(path: Path) -> Gamma:
    try:
        with Pillow.open(path) as picture:
            return _png_curve(picture.info)
    except (OSError, SyntaxError, ValueError):
        return None
