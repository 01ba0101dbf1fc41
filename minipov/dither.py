"""Dithering: ``Dither=on Dither_Method=B4``, switch ``+THB4``.

``B2 B3 B4``  ordered: a pattern of 2, 3 or 4 pixels each way (measured on POV-Ray)
``D1``        the error goes to the next pixel, from row to row (measured)
``D2 FS``     the error goes to the right and below, in two shares or in the four of Floyd and Steinberg (1976)
"""

from __future__ import annotations

from typing import Final

import numpy as np

from minipov.gamma import Floats

_RANKS: Final = {
    "B2": [[3, 0], [1, 2]],
    "B3": [[6, 3, 7], [2, 8, 1], [5, 0, 4]],
    "B4": [[15, 3, 12, 0], [7, 11, 4, 8], [13, 1, 14, 2], [5, 9, 6, 10]],
}
_SHARES: Final = {
    "D1": (1.0, 0.0, 0.0, 0.0),
    "D2": (0.5, 0.25, 0.25, 0.0),
    "FS": (7 / 16, 3 / 16, 5 / 16, 1 / 16),
}
"""How much of the error goes to the right, below left, below, and below right."""

DITHER_METHODS: Final = (*_RANKS, *_SHARES)
_WHOLE: Final = 1e-4
"""A value this near a code is that code."""


def dither(values: Floats, method: str) -> Floats:
    """Return whole numbers for ``values`` (height, width, channels), each rounded up or down."""
    if method in _RANKS:
        return _ordered(values, np.array(_RANKS[method], np.float64))
    return np.stack([_diffused(channel, _SHARES[method]) for channel in np.moveaxis(values, 2, 0)], axis=2)


def _ordered(values: Floats, ranks: Floats) -> Floats:
    height, width, _ = values.shape
    size = len(ranks)
    thresholds = np.tile(ranks / size**2, (-(-height // size), -(-width // size)))[:height, :width]
    return np.asarray(np.ceil(values - thresholds[..., None] - _WHOLE))


def _diffused(channel: Floats, shares: tuple[float, float, float, float]) -> Floats:
    right, below_left, below, below_right = shares
    height, width = channel.shape
    codes = np.empty_like(channel)
    here = [0.0] * (width + 2)
    carried = 0.0
    for y in range(height):
        wanted = channel[y].tolist()
        rounded = [0.0] * width
        under = [0.0] * (width + 2)
        # Only where all of the error goes to the right does it pass on to the next row.
        carried = carried if right == 1.0 else 0.0
        for x in range(width):
            value = wanted[x] + carried + here[x + 1]
            code = float(int(value + 0.5))
            error = value - code
            rounded[x] = code
            carried = right * error
            under[x] += below_left * error
            under[x + 1] += below * error
            under[x + 2] += below_right * error
        codes[y] = rounded
        here = under
    return codes
