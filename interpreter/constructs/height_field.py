"""SDL: ``height_field { png "hills.png" water_level 0.1 smooth }``."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

import numpy as np
from minipov.interpreter.constructs.common import read_fields, switch
from minipov.interpreter.constructs.files import IMAGE_TYPES
from minipov.interpreter.constructs.image_maps import read_image
from minipov.interpreter.constructs.shape import shape
from minipov.interpreter.context import Context
from minipov.interpreter.reader import ItemReader
from minipov.tracer.image import Image
from minipov.tracer.objects import Shape
from minipov.tracer.shapes import HeightField
from numpy.typing import NDArray

STEPS: Final = 65536.0
"""Heights are whole numbers of two bytes, and this is 1."""
GRAY_WEIGHTS: Final = (np.float32(0.297), np.float32(0.589), np.float32(0.114))


def heights_of(picture: Image, *, png: bool = False) -> NDArray[np.float64]:
    """Heights 0 to 1: the palette index, the grey value, or red and green as the two bytes of a number."""
    if picture.index is not None:
        return picture.index.astype(np.float64) * 256.0 / STEPS
    color = picture.color.astype(np.float64)
    if not picture.gray:
        high, low = np.rint(color[..., 0] * 255.0), np.rint(color[..., 1] * 255.0)
        heights: NDArray[np.float64] = (high * 256.0 + low) / STEPS
        return heights
    gray = color[..., 0]
    if png and picture.alpha is None and _is_of_bytes(gray):
        return np.floor(_weighed(gray) * np.float32(255.0)).astype(np.float64) * 257.0 / STEPS
    return np.floor(gray * (STEPS - 1.0) + 0.01) / STEPS


def _is_of_bytes(gray: NDArray[np.float64]) -> bool:
    """Whether a picture has 256 shades at most."""
    shades = gray * 255.0
    return bool(np.abs(shades - np.rint(shades)).max(initial=0.0) < 1e-3)


def _weighed(gray: NDArray[np.float64]) -> NDArray[np.float32]:
    """Shades as the sum of three colours in single precision: POV-Ray loses a shade here and there to rounding."""
    shades = np.rint(gray * 255.0).astype(np.float32) / np.float32(255.0)
    r, g, b = GRAY_WEIGHTS
    return r * shades + g * shades + b * shades


@shape(
    "height_field",
    signature='[type] "file" [gamma G] [water_level F] [smooth] [hierarchy B]',
    doc="A landscape over the unit square, its heights the brightness of a picture.",
    accepts=(*IMAGE_TYPES, "gamma", "water_level", "smooth", "hierarchy"),
)
def height_field(reader: ItemReader, context: Context) -> Shape:
    png = reader.next_is("png")
    field = HeightField(heights_of(read_image(reader, context, "heights"), png=png))
    table = {"water_level": lambda r: {"water_level": _water_level(r, context)}, "smooth": switch("smooth")}
    while (fields := read_fields(reader, table)) is not None:
        field = replace(field, **fields)
    return field


def _water_level(reader: ItemReader, context: Context) -> float:
    """A share of the height; before version 2.0 a number out of 256."""
    level = reader.float()
    return level / 256.0 if context.version < 2.0 else level
