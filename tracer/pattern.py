"""SDL: the patterns that pigments, normals, textures, densities and functions share: ``bozo``, ``gradient x``, ...

A class per pattern, with the pattern's own parameters; what all patterns share stands in `PatternModifiers`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, TypeAlias

import numpy as np
from minipov.tracer.image import ImageMapping
from minipov.tracer.node import node
from minipov.tracer.transform import IDENTITY, Transform
from minipov.tracer.values import Vec2, Vec3
from minipov.tracer.warp import Turbulence, Warp
from numpy.typing import NDArray

if TYPE_CHECKING:
    from minipov.tracer.function import Function
    from minipov.tracer.objects import Object
    from minipov.tracer.pigment import Pigment

Wave: TypeAlias = Literal["ramp_wave", "triangle_wave", "sine_wave", "scallop_wave", "cubic_wave", "poly_wave"]


@node
class PatternModifiers:
    """How a point reaches a pattern and how the value is shaped.

    ``warps`` (transforms among them) stand in source order; ``turbulence`` is the classic modifier, applied after
    all of them. ``frequency`` and ``wave`` None mean the pattern's own. ``noise_generator`` None means the scene's.
    ``uv_mapping`` evaluates at ``(u, v, 0)`` of the surface instead of the point.
    """

    warps: tuple[Warp, ...] = ()
    turbulence: Turbulence | None = None
    frequency: float | None = None
    phase: float = 0.0
    wave: Wave | None = None
    poly_exponent: float = 1.0
    noise_generator: int | None = None
    uv_mapping: bool = False

    def transformed(self, transform: Transform) -> PatternModifiers:
        """The same pattern moved by ``transform``; neighbouring transforms are multiplied out."""
        if transform is IDENTITY:
            return self
        warps = self.warps
        if warps and isinstance(warps[-1], Transform):
            warps = (*warps[:-1], warps[-1].then(transform))
        else:
            warps = (*warps, transform)
        return PatternModifiers(
            warps,
            self.turbulence,
            self.frequency,
            self.phase,
            self.wave,
            self.poly_exponent,
            self.noise_generator,
            self.uv_mapping,
        )


PLAIN = PatternModifiers()


@node
class SimplePattern:
    """A pattern without parameters of its own, by its keyword.

    ``aoi boxed bozo spotted bumps cells checker cubic cylindrical dents granite hexagon leopard marble onion planar
    radial ripples spherical square triangular waves wood wrinkles average``
    """

    name: str


@node
class Agate:
    """``agate agate_turb F``."""

    agate_turb: float = 1.0


@node
class Brick:
    """``brick brick_size V mortar F``."""

    brick_size: Vec3 = (8.0, 3.0, 4.5)
    mortar: float = 0.5


@node
class Crackle:
    """``crackle form V metric F offset F solid``; ``repeat`` (3.8) is the period, 0 none."""

    form: Vec3 = (-1.0, 1.0, 0.0)
    metric: float = 2.0
    offset: float = 0.0
    solid: bool = False
    repeat: Vec3 = (0.0, 0.0, 0.0)


@node(eq=False)
class DensityFile:
    """``density_file df3 "f.df3" interpolate I``; ``voxels`` has shape (z, y, x), float32 in 0..1."""

    voxels: NDArray[np.float32]
    interpolate: int = 0


@node
class Facets:
    """``facets size F metric F`` or ``facets coords F size F`` (normals only).

    ``coords`` 0 cuts the directions of normals into pieces, else space, and is how far pieces are turned.
    """

    coords: float = 0.0
    size: float = 0.1
    metric: float = 2.0


@node
class FunctionPattern:
    """``function { ... }`` used as a pattern of x, y, z."""

    function: Function


@node
class Gradient:
    """``gradient V``."""

    direction: Vec3


@node
class ImageMap:
    """``image_map { ... }`` in a pigment. Filter and transmit by palette index, or for ``all`` (index None)."""

    mapping: ImageMapping
    filter: tuple[tuple[int | None, float], ...] = ()
    transmit: tuple[tuple[int | None, float], ...] = ()


@node
class ImagePattern:
    """``image_pattern { ... }``: the grey value of a picture."""

    mapping: ImageMapping


@node
class BumpMap:
    """``bump_map { ... }`` (normals only): the brightness of a picture, or its palette numbers, as heights."""

    mapping: ImageMapping


@node
class Fractal:
    """``mandel I``, ``julia V2, I``, ``magnet 1|2 mandel|julia``; ``coordinate`` None means the Mandelbrot kind."""

    max_iteration: int
    coordinate: Vec2 | None = None
    magnet: int = 0
    exponent: int = 2
    exterior: tuple[int, float] = (1, 1.0)
    interior: tuple[int, float] = (0, 1.0)


@node
class ObjectPattern:
    """``object { OBJECT }``: 1 inside, 0 outside."""

    object: Object


@node
class Pavement:
    """``pavement number_of_sides I number_of_tiles I pattern I form I interior I exterior I``."""

    number_of_sides: int = 3
    number_of_tiles: int = 1
    pattern: int = 1
    form: int = 0
    interior: int = 0
    exterior: int = 0


@node
class PigmentPattern:
    """``pigment_pattern { ... }``: the grey value of a pigment."""

    pigment: Pigment


@node
class Potential:
    """``potential { OBJECT threshold B }`` (3.8): the field of a blob or isosurface."""

    object: Object
    threshold: bool = False


@node
class Quilted:
    """``quilted control0 F control1 F``."""

    control0: float = 1.0
    control1: float = 1.0


@node
class Slope:
    """``slope { V, lo, hi altitude V, lo, hi }``; ``point_at`` says that the direction is a point to look towards."""

    direction: Vec3
    low: float = 0.0
    high: float = 1.0
    point_at: bool = False
    altitude: Vec3 | None = None
    altitude_low: float = 0.0
    altitude_high: float = 1.0


@node
class Spiral:
    """``spiral1 I`` (kind 1) and ``spiral2 I`` (kind 2)."""

    kind: Literal[1, 2]
    arms: int


@node
class Tiling:
    """``tiling I``, 1..27."""

    number: int


Pattern: TypeAlias = (
    SimplePattern
    | Agate
    | Brick
    | BumpMap
    | Crackle
    | DensityFile
    | Facets
    | FunctionPattern
    | Gradient
    | ImageMap
    | ImagePattern
    | Fractal
    | ObjectPattern
    | Pavement
    | PigmentPattern
    | Potential
    | Quilted
    | Slope
    | Spiral
    | Tiling
)
