"""SDL: ``camera { perspective location V look_at V angle F aperture F ... }``.

The interpreter has already done look_at, sky, angle and the transforms: what is left is a frame of vectors.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, TypeAlias

from minipov.tracer.function import Function
from minipov.tracer.node import node
from minipov.tracer.normal import Normal
from minipov.tracer.pigment import Pigment
from minipov.tracer.transform import IDENTITY, Transform
from minipov.tracer.values import Vec3

if TYPE_CHECKING:
    from minipov.tracer.objects import Object

CameraKind: TypeAlias = Literal[
    "perspective",
    "orthographic",
    "fisheye",
    "ultra_wide_angle",
    "omnimax",
    "panoramic",
    "spherical",
    "cylinder1",
    "cylinder2",
    "cylinder3",
    "cylinder4",
    "mesh_camera",
    "user_defined",
]


@node
class FocalBlur:
    """``aperture F blur_samples min, max focal_point V confidence F variance F bokeh { pigment }``.

    ``focal_distance`` is the distance along ``direction`` (in its units of length) at which things are sharp.
    """

    aperture: float
    blur_samples: tuple[int, int]
    focal_distance: float
    confidence: float = 0.9
    variance: float = 1 / 10000
    bokeh: Pigment | None = None


@node
class MeshCamera:
    """``mesh_camera { rays_per_pixel distribution max_distance mesh {...} smooth }``.

    Of the camera's vectors only two numbers count: the z of ``location`` shifts the start of each ray along the normal
    of its face, and a negative z of ``direction`` turns the rays round.
    """

    rays_per_pixel: int
    distribution: int
    meshes: tuple[Object, ...]
    max_distance: float | None = None
    smooth: bool = False


@node
class UserDefinedCamera:
    """3.8 ``user_defined``: functions of (x, y) in -0.5..0.5 for location and direction; None uses the vector.

    ``transform`` carries along what the functions give.
    """

    location: tuple[Function, Function, Function] | None = None
    direction: tuple[Function, Function, Function] | None = None
    transform: Transform = IDENTITY


@node
class Camera:
    """From where and how the picture is taken.

    A perspective ray through picture coordinates (u, v) in -0.5..0.5 is ``direction + u * right + v * up``.
    ``angle`` (horizontal) and ``vertical_angle`` in degrees for the kinds that use them.
    """

    kind: CameraKind = "perspective"
    location: Vec3 = (0.0, 0.0, 0.0)
    direction: Vec3 = (0.0, 0.0, 1.0)
    right: Vec3 = (1.33, 0.0, 0.0)
    up: Vec3 = (0.0, 1.0, 0.0)
    angle: float = 90.0
    vertical_angle: float = 180.0
    focal_blur: FocalBlur | None = None
    normal: Normal | None = None
    mesh: MeshCamera | None = None
    user_defined: UserDefinedCamera | None = None
