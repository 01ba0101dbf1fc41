"""Gamma: between the working space of a scene, linear light, and what a file stores.

SDL: ``global_settings { assumed_gamma 1.0 }`` names the working space; the option ``File_Gamma`` the curve of the file.
A working space of None is that of scenes before ``#version 3.7`` without ``assumed_gamma``: numbers pass unchanged, and
POV-Ray takes them for sRGB's where a file must be linear.

The sRGB curve is that of IEC 61966-2-1, with the constants POV-Ray uses (measured: no 8-bit code differs).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from minipov.tracer.settings import Gamma

Floats = NDArray[np.float64]


def decode(values: Floats, gamma: Gamma) -> Floats:
    """Return linear light for ``values`` stored with ``gamma``; negative numbers keep their sign."""
    if gamma is None or gamma == 1.0:
        return values
    size = np.abs(values)
    if gamma == "srgb":
        linear = np.where(size <= 0.04045, size / 12.92, ((size + 0.055) / 1.055) ** 2.4)
    else:
        linear = size**gamma
    return np.copysign(linear, values)


def encode(linear: Floats, gamma: Gamma) -> Floats:
    """Return what a file with ``gamma`` stores for linear light: the inverse of `decode`."""
    if gamma is None or gamma == 1.0:
        return linear
    size = np.abs(linear)
    if gamma == "srgb":
        stored = np.where(size <= 0.0031308, size * 12.92, 1.055 * size ** (1 / 2.4) - 0.055)
    else:
        stored = size ** (1 / gamma)
    return np.copysign(stored, linear)


def convert(values: Floats, source: Gamma, target: Gamma) -> Floats:
    """Re-express ``values`` of one space in another; equal spaces, and None on either side, change nothing."""
    if source == target or source is None or target is None:
        return values
    return encode(decode(values, source), target)


def parse_gamma(text: str) -> Gamma:
    """Read ``sRGB`` or a number, as ``File_Gamma`` takes it.

    Raises:
        ValueError: neither.
    """
    if text.strip().lower() == "srgb":
        return "srgb"
    value = float(text)
    if value <= 0:
        raise ValueError("a gamma is greater than 0")
    return value
