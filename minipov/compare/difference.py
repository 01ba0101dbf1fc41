"""The picture of a difference: FLIP's error, dark where nothing differs, through red to white."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image

from minipov.compare.metrics import Picture, flip_map, read_picture

_RAMP = np.array([[0, 0, 0], [80, 18, 90], [180, 50, 80], [245, 130, 40], [252, 253, 190]], np.float64)
"""Colours for errors 0, 0.25, 0.5, 0.75 and 1."""


def difference_picture(picture: Picture, reference: Picture) -> Picture:
    """Return the error of each pixel as a colour; the pictures have the same size."""
    errors = flip_map(picture, reference)
    stops = np.linspace(0, 1, len(_RAMP))
    return np.stack([np.interp(errors, stops, _RAMP[:, channel]) for channel in range(3)], axis=2).astype(np.uint8)


def write_difference(picture: Path, reference: Path, target: Path) -> bool:
    """Write the difference of two files as PNG; False where they cannot be compared."""
    try:
        a, b = read_picture(picture), read_picture(reference)
    except OSError:
        return False
    if a.shape != b.shape:
        return False
    Image.fromarray(difference_picture(a, b)).save(target)
    return True
