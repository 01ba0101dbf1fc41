"""SDL: ``light_source { location, color spotlight point_at V radius F falloff F tightness F area_light ... }``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from minipov.tracer.node import node, replace
from minipov.tracer.transform import Transform
from minipov.tracer.values import Rgb, Vec3

if TYPE_CHECKING:
    from minipov.tracer.objects import Object


@node
class AreaLight:
    """``area_light axis1, axis2, size1, size2``; ``adaptive`` None samples the whole grid."""

    axis1: Vec3
    axis2: Vec3
    size1: int
    size2: int
    adaptive: int | None = None
    jitter: bool = False
    circular: bool = False
    orient: bool = False
    area_illumination: bool = False


@node
class LightPhotons:
    """``photons { reflection B refraction B area_light }`` of a light."""

    reflection: bool | None = None
    refraction: bool | None = None
    area_light: bool = False


@node
class LightSource:
    """A light. Spot ``radius`` and ``falloff`` are angles in degrees, cylinder ones lengths.

    ``fade_power`` 0 or ``fade_distance`` 0 mean no fading (with ``#version`` 3.8, distance 0 is the pure power law,
    which the interpreter says by ``pure_power``). ``looks_like`` stands where it appears (already at the light).
    """

    location: Vec3
    color: Rgb
    kind: Literal["point", "spotlight", "cylinder"] = "point"
    point_at: Vec3 = (0.0, 0.0, 1.0)
    radius: float = 30.0
    falloff: float = 45.0
    tightness: float = 0.0
    parallel: bool = False
    shadowless: bool = False
    area: AreaLight | None = None
    fade_distance: float = 0.0
    fade_power: float = 0.0
    pure_power: bool = False
    media_interaction: bool = True
    media_attenuation: bool = False
    looks_like: Object | None = None
    projected_through: Object | None = None
    photons: LightPhotons | None = None

    def transformed(self, transform: Transform) -> LightSource:
        """The same light, moved: location, target, area axes, looks_like and projected_through."""
        area = self.area and replace(
            self.area, axis1=transform.direction(self.area.axis1), axis2=transform.direction(self.area.axis2)
        )
        return replace(
            self,
            location=transform.point(self.location),
            point_at=transform.point(self.point_at),
            area=area,
            looks_like=self.looks_like and self.looks_like.transformed(transform),
            projected_through=self.projected_through and self.projected_through.transformed(transform),
        )
