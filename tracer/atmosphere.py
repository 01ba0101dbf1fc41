"""SDL: ``background``, ``fog``, ``rainbow``, ``sky_sphere``: what surrounds the objects."""

from __future__ import annotations

import math

from minipov.tracer.node import node
from minipov.tracer.pigment import ColorMap, Pigment
from minipov.tracer.values import WHITE, Rgb, Rgbft, Vec3
from minipov.tracer.warp import Turbulence


@node
class Fog:
    """``fog { fog_type 1|2 distance F color C fog_offset F fog_alt F up V turbulence V turb_depth F }``."""

    distance: float
    color: Rgbft
    fog_type: int = 1
    fog_offset: float = 0.0
    fog_alt: float = 0.0
    up: Vec3 = (0.0, 1.0, 0.0)
    turbulence: Turbulence | None = None
    turb_depth: float = 0.5


@node
class Rainbow:
    """``rainbow { direction V angle F width F distance F color_map {...} ... }``, angles in degrees.

    Without a width or colours nothing is seen of it. An infinite `arc_angle` is the whole circle.
    """

    direction: Vec3
    angle: float = 0.0
    width: float = 0.0
    color_map: ColorMap | None = None
    distance: float = 1e7
    jitter: float = 0.0
    up: Vec3 = (0.0, 1.0, 0.0)
    arc_angle: float = math.inf
    falloff_angle: float = math.inf


@node
class SkySphere:
    """``sky_sphere { pigment {...} pigment {...} emission C }``: layered pigments looked up by direction."""

    pigments: tuple[Pigment, ...]
    emission: Rgb = WHITE
