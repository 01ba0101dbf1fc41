"""SDL: ``height_field { png "hills.png" water_level 0.1 smooth }``."""

from __future__ import annotations

from typing import Final

import numpy as np
from minipov.interpreter.constructs.common import read_fields, switch
from minipov.interpreter.constructs.files import IMAGE_TYPES
from minipov.interpreter.constructs.function_images import sampled_heights
from minipov.interpreter.constructs.image_maps import read_image
from minipov.interpreter.constructs.shape import shape
from minipov.interpreter.context import Context
from minipov.interpreter.items import FunctionImage
from minipov.interpreter.reader import ItemReader
from minipov.tracer.image import Image
from minipov.tracer.node import replace
from minipov.tracer.objects import Shape
from minipov.tracer.shapes import HeightField
from numpy.typing import NDArray

STEPS: Final = 65536.0
"""Heights are whole numbers of two bytes, and this is 1."""


def heights_of(picture: Image) -> NDArray[np.float64]:
    """Heights 0 to 1: the palette index, the grey value, or red and green as the two bytes of a number."""
    if picture.index is not None:
        return picture.index.astype(np.float64) * 256.0 / STEPS
    color = picture.color.astype(np.float64)
    if not picture.gray:
        high, low = np.rint(color[..., 0] * 255.0), np.rint(color[..., 1] * 255.0)
        steps: NDArray[np.float64] = high * 256.0 + low
    else:
        steps = np.floor(color[..., 0] * (STEPS - 1.0) + 0.01)
    return steps / STEPS


@shape(
    "height_field",
    signature='[type] "file" [gamma G] [water_level F] [smooth] [hierarchy B]',
    doc="A landscape over the unit square, its heights the brightness of a picture.",
    accepts=(*IMAGE_TYPES, "gamma", "water_level", "smooth", "hierarchy"),
)
def height_field(reader: ItemReader, context: Context) -> Shape:
    source = reader.node(FunctionImage)
    heights = heights_of(read_image(reader, context, "heights")) if source is None else sampled_heights(source)
    field = HeightField(heights)
    table = {"water_level": lambda r: {"water_level": _water_level(r, context)}, "smooth": switch("smooth")}
    while (fields := read_fields(reader, table)) is not None:
        field = replace(field, **fields)
    return field


def _water_level(reader: ItemReader, context: Context) -> float:
    """A share of the height; before version 2.0 a number out of 256."""
    level = reader.float()
    return level / 256.0 if context.version < 2.0 else level
