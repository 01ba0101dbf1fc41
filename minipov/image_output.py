"""Writing a picture: INI ``Output_File_Type=N8 File_Gamma=sRGB Output_Alpha=on``, switches ``+FN16 +UA``.

What was measured on POV-Ray 3.7, and is reproduced here: codes are rounded to the nearest, halves up; 5 to 16 bits are
possible in PNG and PPM, and PNG spreads them over 8 or 16; PNG, TGA and BMP store colour not multiplied by alpha, after
alpha was raised to the pixel's grey where that is larger; EXR stores half floats, multiplied; EXR and HDR are linear.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from typing import Literal

import numpy as np
import OpenImageIO as oiio
from numpy.typing import NDArray

from minipov.dither import dither
from minipov.gamma import Floats, convert, decode
from minipov.image_format import EXTENSIONS, FileFormat
from minipov.tracer.settings import Gamma

GREY_WEIGHTS = np.array([0.297, 0.589, 0.114])
"""How POV-Ray weighs red, green and blue where it needs one grey."""

_FLOAT_KINDS = frozenset({"exr", "hdr"})
_DEEP_KINDS = frozenset({"png", "ppm"})


def write_image(path: Path | Literal["-"], pixels: NDArray[np.floating], working: Gamma, file: FileFormat) -> None:
    """Write ``pixels`` (height, width, 4), working-space colours multiplied by alpha; "-" is standard output.

    The file appears complete or not at all. Raises OSError where it cannot be written.
    """
    if path == "-":
        with tempfile.TemporaryDirectory() as folder:
            scratch = Path(folder) / ("picture" + EXTENSIONS[file.kind])
            write_image(scratch, pixels, working, file)
            sys.stdout.buffer.write(scratch.read_bytes())
            sys.stdout.buffer.flush()
        return
    channels = stored_channels(np.asarray(pixels, np.float64), working, file)
    unfinished = path.with_name(f"{path.stem}.part{EXTENSIONS[file.kind]}")
    try:
        if file.kind == "ppm":
            unfinished.write_bytes(_netpbm(channels, file.bits))
        else:
            _write_with_oiio(unfinished, channels, file)
        unfinished.replace(path)
    finally:
        unfinished.unlink(missing_ok=True)


def stored_channels(pixels: Floats, working: Gamma, file: FileFormat) -> NDArray[np.float32 | np.uint8 | np.uint16]:
    """Return what the file holds: (height, width, channels) of integer codes, or of linear floats for EXR and HDR."""
    color, alpha = pixels[..., :3], pixels[..., 3:4]
    if file.gray:
        color = (color @ GREY_WEIGHTS)[..., None]
    if file.kind in _FLOAT_KINDS:
        linear = decode(color, "srgb" if working is None else working)
        return np.concatenate([linear, alpha] if file.stores_alpha else [linear], axis=2).astype(np.float32)
    if file.stores_alpha:
        color, alpha = unmultiplied(color, alpha)
    stored = np.clip(convert(color, working, file.gamma), 0, 1)
    if file.stores_alpha:
        stored = np.concatenate([stored, np.clip(alpha, 0, 1)], axis=2)
    largest = (1 << (file.bits if file.kind in _DEEP_KINDS else 8)) - 1
    codes = dither(stored * largest, file.dither) if file.dither else np.floor(stored * largest + 0.5)
    codes = np.clip(codes, 0, largest)
    if file.kind == "ppm":
        return codes.astype(np.uint16)
    container = 255 if largest <= 255 else 65535
    if largest != container:
        codes = np.floor(codes * (container / largest) + 0.5)
    return codes.astype(np.uint8 if container == 255 else np.uint16)


def unmultiplied(color: Floats, alpha: Floats) -> tuple[Floats, Floats]:
    """Divide by alpha, raised first to the pixel's grey so that bright light on a clear ground stays visible."""
    grey = color @ GREY_WEIGHTS if color.shape[-1] == 3 else color[..., 0]
    raised = np.maximum(alpha, np.minimum(grey[..., None], 1.0))
    return np.divide(color, raised, out=np.zeros_like(color), where=raised > 0), raised


def _netpbm(codes: NDArray[np.float32 | np.uint8 | np.uint16], bits: int) -> bytes:
    height, width, channels = codes.shape
    header = f"P{6 if channels == 3 else 5}\n{width} {height}\n{(1 << bits) - 1}\n".encode()
    return header + codes.astype(">u2" if bits > 8 else "u1").tobytes()


def _write_with_oiio(path: Path, channels: NDArray[np.float32 | np.uint8 | np.uint16], file: FileFormat) -> None:
    height, width, count = channels.shape
    stored_type = "half" if file.kind == "exr" else str(channels.dtype).replace("float32", "float")
    spec = oiio.ImageSpec(width, height, count, stored_type)
    spec.attribute("Software", "minipov")
    if file.kind == "exr":
        spec.attribute("compression", "zip")
    elif file.kind == "jpeg":
        spec.attribute("Compression", f"jpeg:{file.quality}")
    elif file.kind in ("tga", "tga_rle"):
        spec.attribute("compression", "rle" if file.kind == "tga_rle" else "none")
    if file.kind not in _FLOAT_KINDS:
        spec.attribute("oiio:UnassociatedAlpha", 1)
        _name_curve(spec, file.gamma)
    output = oiio.ImageOutput.create(str(path))
    if output is None or not output.open(str(path), spec):
        raise OSError(f"cannot write {path}: {output.geterror() if output else oiio.geterror()}")
    written = output.write_image(np.ascontiguousarray(channels))
    closed = output.close()
    if not (written and closed):
        raise OSError(f"cannot write {path}: {output.geterror()}")


def _name_curve(spec: oiio.ImageSpec, gamma: Gamma) -> None:
    if isinstance(gamma, float):
        spec.attribute("oiio:Gamma", gamma)
        spec.attribute("oiio:ColorSpace", "lin_rec709_scene" if gamma == 1.0 else f"g{gamma * 10:.0f}_rec709_scene")
    else:
        spec.attribute("oiio:ColorSpace", "srgb_rec709_scene")
