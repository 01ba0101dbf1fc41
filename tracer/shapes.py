"""SDL: the primitives: ``sphere``, ``box``, ``cylinder``, ... Each stands in its own space; `Object` places it."""

from __future__ import annotations

from typing import Literal, TypeAlias

import numpy as np
from minipov.tracer.function import Function
from minipov.tracer.node import node
from minipov.tracer.texture import Texture
from minipov.tracer.transform import IDENTITY, Transform
from minipov.tracer.values import Vec2, Vec3, Vec4
from numpy.typing import NDArray

SplineKind: TypeAlias = Literal["linear_spline", "quadratic_spline", "cubic_spline", "bezier_spline", "b_spline"]


@node
class Sphere:
    """``sphere { center, radius }``."""

    center: Vec3
    radius: float


@node
class Box:
    """``box { corner, corner }``, corners in any order."""

    corner1: Vec3
    corner2: Vec3


@node
class Cylinder:
    """``cylinder { base, cap, radius open }``."""

    base: Vec3
    cap: Vec3
    radius: float
    open: bool = False


@node
class Cone:
    """``cone { base, radius, cap, radius open }``."""

    base: Vec3
    base_radius: float
    cap: Vec3
    cap_radius: float
    open: bool = False


@node
class Plane:
    """``plane { normal, distance }``: points p with ``p . n/|n| = distance``; the inside lies against the normal."""

    normal: Vec3
    distance: float


@node
class Disc:
    """``disc { center, normal, radius, hole }``."""

    center: Vec3
    normal: Vec3
    radius: float
    hole_radius: float = 0.0


@node
class Torus:
    """``torus { major, minor sturm }`` about the y axis; ``spindle`` (3.8) for minor > major."""

    major_radius: float
    minor_radius: float
    spindle: Literal["difference", "intersection", "merge", "union"] | None = None
    sturm: bool = False


@node
class Quadric:
    """``quadric { <A,B,C>, <D,E,F>, <G,H,I>, J }``.

    A x² + B y² + C z² + D xy + E xz + F yz + G x + H y + I z + J = 0; negative inside.
    """

    squares: Vec3
    mixed: Vec3
    linear: Vec3
    constant: float


@node
class Poly:
    """``poly { order, <coefficients> }``, also ``cubic``, ``quartic``, ``polynomial``.

    (order+1)(order+2)(order+3)/6 coefficients by falling power of x, then y, then z.
    """

    order: int
    coefficients: tuple[float, ...]
    sturm: bool = False


@node
class Polygon:
    """``polygon { n, points }``; a repeated first point closes a ring; rings overlap by even-odd."""

    points: tuple[Vec3, ...]


@node
class Triangle:
    """``triangle { a, b, c }``."""

    a: Vec3
    b: Vec3
    c: Vec3


@node
class SmoothTriangle:
    """``smooth_triangle { a, normal_a, b, normal_b, c, normal_c }``."""

    a: Vec3
    normal_a: Vec3
    b: Vec3
    normal_b: Vec3
    c: Vec3
    normal_c: Vec3


@node(eq=False)
class Mesh:
    """``mesh`` and ``mesh2``.

    ``vertices`` (n, 3), ``normals`` (m, 3) or None, ``uvs`` (k, 2) or None: float64. ``faces`` (f, 3) int32 index
    vertices; ``normal_faces`` and ``uv_faces`` (f, 3) int32 index the others, -1 in a row for a flat face.
    ``face_textures`` (f, 3) int32 indexes ``textures`` per corner, -1 for the object's own texture.
    """

    vertices: NDArray[np.float64]
    faces: NDArray[np.int32]
    normals: NDArray[np.float64] | None = None
    normal_faces: NDArray[np.int32] | None = None
    uvs: NDArray[np.float64] | None = None
    uv_faces: NDArray[np.int32] | None = None
    textures: tuple[Texture, ...] = ()
    face_textures: NDArray[np.int32] | None = None
    inside_vector: Vec3 | None = None


@node
class BicubicPatch:
    """``bicubic_patch { type T flatness F u_steps I v_steps I, 16 points }``."""

    points: tuple[Vec3, ...]
    type: int = 0
    flatness: float = 0.0
    u_steps: int = 0
    v_steps: int = 0
    uv_vectors: tuple[Vec2, Vec2, Vec2, Vec2] = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))


@node
class BlobComponent:
    """A ``sphere`` (``end`` None) or ``cylinder`` of a blob, with its own transform and texture."""

    center: Vec3
    radius: float
    strength: float
    end: Vec3 | None = None
    transform: Transform = IDENTITY
    texture: Texture | None = None


@node
class Blob:
    """``blob { threshold F sphere {...} cylinder {...} }``."""

    components: tuple[BlobComponent, ...]
    threshold: float = 1.0
    sturm: bool = False
    hierarchy: bool = True


@node(eq=False)
class HeightField:
    """``height_field { ... }`` on the unit square.

    ``heights`` (rows, columns), float64 in 0..1, row 0 at z = 1 (the top of the picture).
    """

    heights: NDArray[np.float64]
    water_level: float = 0.0
    smooth: bool = False


@node
class Isosurface:
    """``isosurface { function {...} contained_by {...} threshold F max_gradient F ... }``.

    ``evaluate`` holds P0, P1, P2, or None. ``polarity`` (3.8) True turns inside and outside round.
    """

    function: Function
    contained_by: Sphere | Box = Box((-1.0, -1.0, -1.0), (1.0, 1.0, 1.0))
    threshold: float = 0.0
    accuracy: float = 0.001
    max_gradient: float = 1.1
    evaluate: Vec3 | None = None
    open: bool = False
    max_trace: int = 1
    all_intersections: bool = False
    polarity: bool = False


@node
class Parametric:
    """``parametric { function{}, function{}, function{} <u,v>, <u,v> contained_by {...} precompute D, x, y, z }``."""

    functions: tuple[Function, Function, Function]
    low: Vec2
    high: Vec2
    contained_by: Sphere | Box = Box((-1.0, -1.0, -1.0), (1.0, 1.0, 1.0))
    max_gradient: float = 1.0
    accuracy: float = 0.001
    precompute: tuple[int, bool, bool, bool] | None = None


@node
class JuliaFractal:
    """``julia_fractal { parameter quaternion sqr max_iteration I precision F slice V4, F }``."""

    parameter: Vec4
    algebra: Literal["quaternion", "hypercomplex"] = "quaternion"
    function: str = "sqr"
    exponent: Vec2 = (0.0, 0.0)
    max_iteration: int = 20
    precision: float = 20.0
    slice_normal: Vec4 = (0.0, 0.0, 0.0, 1.0)
    slice_distance: float = 0.0


@node
class Lathe:
    """``lathe { spline n, points sturm }``: a curve in (radius, y) turned about the y axis."""

    spline: SplineKind
    points: tuple[Vec2, ...]
    sturm: bool = False


@node
class Lemon:
    """3.8 ``lemon { base, radius, cap, radius, inner_radius }``."""

    base: Vec3
    base_radius: float
    cap: Vec3
    cap_radius: float
    inner_radius: float
    open: bool = False


@node
class Ovus:
    """``ovus { bottom_radius, top_radius }``; the rest is 3.8."""

    bottom_radius: float
    top_radius: float
    radius: float | None = None
    distance: float | None = None
    precision: float = 1e-4


@node
class Prism:
    """``prism { spline sweep height1, height2, n, points open }``; points are (x, z)."""

    spline: SplineKind
    sweep: Literal["linear_sweep", "conic_sweep"]
    height1: float
    height2: float
    points: tuple[Vec2, ...]
    open: bool = False
    sturm: bool = False


@node
class SphereSweep:
    """``sphere_sweep { spline n, center, radius, ... tolerance F }``."""

    spline: SplineKind
    spheres: tuple[tuple[Vec3, float], ...]
    tolerance: float = 1e-6


@node
class Superellipsoid:
    """``superellipsoid { <e, n> }``."""

    e: float
    n: float


@node
class Sor:
    """``sor { n, points open sturm }``: a surface of revolution; points are (radius, height)."""

    points: tuple[Vec2, ...]
    open: bool = False
    sturm: bool = False


@node
class Text:
    """``text { ttf "font.ttf" "words" thickness, offset }``; ``font`` is the file's bytes."""

    font: bytes
    text: str
    thickness: float
    offset: Vec3 = (0.0, 0.0, 0.0)
