"""SDL: ``background``, ``fog``, ``rainbow``, ``sky_sphere``: what surrounds the objects."""

from __future__ import annotations

from dataclasses import dataclass

from minipov.tracer.pigment import ColorMap, Pigment
from minipov.tracer.values import WHITE, Rgb, Rgbft, Vec3
from minipov.tracer.warp import Turbulence


@dataclass(frozen=True, slots=True)
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


@dataclass(frozen=True, slots=True)
class Rainbow:
    """``rainbow { direction V angle F width F distance F color_map {...} ... }``, angles in degrees."""

    direction: Vec3
    angle: float
    width: float
    color_map: ColorMap
    distance: float = 1e7
    jitter: float = 0.0
    up: Vec3 = (0.0, 1.0, 0.0)
    arc_angle: float = 180.0
    falloff_angle: float = 180.0


@dataclass(frozen=True, slots=True)
class SkySphere:
    """``sky_sphere { pigment {...} pigment {...} emission C }``: layered pigments looked up by direction."""

    pigments: tuple[Pigment, ...]
    emission: Rgb = WHITE
