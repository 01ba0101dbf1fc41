"""Plain value types of the scene graph: vectors and colours are tuples of floats."""

from __future__ import annotations

from typing import TypeAlias

Vec2: TypeAlias = tuple[float, float]
Vec3: TypeAlias = tuple[float, float, float]
Vec4: TypeAlias = tuple[float, float, float, float]

Rgb: TypeAlias = tuple[float, float, float]
"""Red, green, blue in the scene's working space; not limited to 0..1."""

Rgbft: TypeAlias = tuple[float, float, float, float, float]
"""Red, green, blue, filter, transmit."""

BLACK: Rgb = (0.0, 0.0, 0.0)
WHITE: Rgb = (1.0, 1.0, 1.0)
OPAQUE_BLACK: Rgbft = (0.0, 0.0, 0.0, 0.0, 0.0)
