"""SDL: ``warp { turbulence <1,1,1> }``, ``warp { repeat x*2 flip y }``, ``warp { black_hole <0,0,0>, 1 }``, ..."""

from __future__ import annotations

from typing import TypeAlias

from minipov.tracer.node import node
from minipov.tracer.transform import Transform
from minipov.tracer.values import Vec3


@node
class Turbulence:
    """A displacement by fractal noise: ``turbulence amount octaves 6 omega 0.5 lambda 2``."""

    amount: Vec3
    octaves: int = 6
    omega: float = 0.5
    lambda_: float = 2.0


@node
class RepeatWarp:
    """``repeat V``: copies along one axis; ``flip`` mirrors every other copy along the axes that are not zero."""

    axis: int
    width: float
    offset: Vec3 = (0.0, 0.0, 0.0)
    flip: tuple[bool, bool, bool] = (False, False, False)


@node
class BlackHoleWarp:
    """``black_hole centre, radius``: pulls towards (or, inverse, pushes from) a centre."""

    center: Vec3
    radius: float
    strength: float = 1.0
    falloff: float = 2.0
    inverse: bool = False
    repeat: Vec3 | None = None
    turbulence: Vec3 = (0.0, 0.0, 0.0)


@node
class CylindricalWarp:
    """``cylindrical``: wraps the unit square round the y axis."""

    orientation: Vec3 = (0.0, 0.0, 1.0)
    dist_exp: float = 0.0


@node
class SphericalWarp:
    """``spherical``: wraps the unit square round the origin."""

    orientation: Vec3 = (0.0, 0.0, 1.0)
    dist_exp: float = 0.0


@node
class ToroidalWarp:
    """``toroidal``: wraps the unit square round a torus about the y axis."""

    orientation: Vec3 = (0.0, 0.0, 1.0)
    dist_exp: float = 0.0
    major_radius: float = 1.0


@node
class PlanarWarp:
    """``planar``: flattens space on a plane."""

    normal: Vec3 = (0.0, 0.0, 1.0)
    distance: float = 0.0


@node
class CubicWarp:
    """``cubic``: the unfolding of the unit cube."""


Warp: TypeAlias = (
    Transform
    | Turbulence
    | RepeatWarp
    | BlackHoleWarp
    | CylindricalWarp
    | SphericalWarp
    | ToroidalWarp
    | PlanarWarp
    | CubicWarp
)
