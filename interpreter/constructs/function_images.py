"""SDL: ``function 200, 200 { pigment {...} }`` in place of an image file: a function sampled on the unit square."""

from __future__ import annotations

import numpy as np
from minipov.interpreter.items import FunctionImage
from minipov.interpreter.runtime.evaluate import call_function
from minipov.tracer.function import PigmentFunction
from minipov.tracer.image import Image


def sampled(source: FunctionImage) -> Image:
    """The picture of a function: x runs from 0 to 1 over the columns, y over the rows from the top, z is 0.

    Values wrap round at 1, as the 16-bit numbers of the reference do: whole numbers above 0 stay 1.
    """
    xs = [column / max(source.width - 1, 1) for column in range(source.width)]
    ys = [row / max(source.height - 1, 1) for row in range(source.height)]
    values = np.array([[call_function(source.function, (x, y, 0.0)) for x in xs] for y in ys], dtype=np.float64)
    if isinstance(source.function, PigmentFunction):
        color, transmit = values[..., :3], values[..., 3] + values[..., 4]
        alpha = np.clip(1.0 - transmit, 0.0, 1.0).astype(np.float32) if transmit.any() else None
        return Image(color.astype(np.float32), alpha)
    wrapped = values - np.floor(values)
    wrapped[(wrapped == 0.0) & (values != 0.0)] = 1.0
    return Image(np.repeat(wrapped[..., np.newaxis], 3, axis=2).astype(np.float32), gray=True)
