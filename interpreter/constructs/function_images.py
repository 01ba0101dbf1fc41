"""SDL: ``function 200, 200 { pigment {...} }`` in place of an image file: a function sampled on the unit square."""

from __future__ import annotations

from typing import Final

import numpy as np
from minipov.interpreter.errors import SdlError
from minipov.interpreter.items import FunctionImage
from minipov.interpreter.runtime.evaluate import compiled_function
from minipov.tracer.function import PigmentFunction
from minipov.tracer.image import Image
from numpy.typing import NDArray

STEPS: Final = 65535.0
"""Channels have 16 bits."""


def sampled(source: FunctionImage) -> Image:
    """The picture of a function: x runs from 0 to 1 over the columns, y over the rows from the top, z is 0.

    Pigments are cut off at 0 and 1; the grey of other functions wraps round as 16-bit numbers do.
    """
    values = _values(source)
    if isinstance(source.function, PigmentFunction):
        color, transmit = _rounded(values[..., :3]), values[..., 3] + values[..., 4]
        alpha = np.clip(1.0 - transmit, 0.0, 1.0).astype(np.float32) if transmit.any() else None
        return Image(color.astype(np.float32), alpha)
    gray = _wrapped(values[..., :1])
    return Image(np.repeat(gray, 3, axis=2).astype(np.float32), gray=True)


def sampled_heights(source: FunctionImage) -> NDArray[np.float64]:
    """The heights of a landscape: greys, of which 1 is one step below the top."""
    values = _values(source)
    if isinstance(source.function, PigmentFunction):
        red, green, blue = np.moveaxis(_rounded(values[..., :3]), -1, 0)
        steps = np.floor((0.297 * red + 0.589 * green + 0.114 * blue) * STEPS)
    else:
        steps = np.rint(_wrapped(values[..., 0]) * STEPS)
    heights: NDArray[np.float64] = steps / (STEPS + 1.0)
    return heights


MOST_PIXELS: Final = 1 << 26


def _values(source: FunctionImage) -> NDArray[np.float64]:
    if source.width * source.height > MOST_PIXELS:
        raise SdlError(f"a function image of {source.width} by {source.height} pixels is too large")
    flat = compiled_function(source.function).unit_square(source.width, source.height)
    return np.array(flat, dtype=np.float64).reshape(source.height, source.width, -1)


def _rounded(values: NDArray[np.float64]) -> NDArray[np.float64]:
    rounded: NDArray[np.float64] = np.floor(np.clip(values, 0.0, 1.0) * STEPS) / STEPS
    return rounded


def _wrapped(values: NDArray[np.float64]) -> NDArray[np.float64]:
    wrapped: NDArray[np.float64] = np.mod(np.trunc(np.nan_to_num(values) * STEPS), STEPS + 1.0) / STEPS
    return wrapped
