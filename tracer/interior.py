"""SDL: ``interior { ior 1.5 fade_distance 2 media { scattering { 1, 0.2 } } }``."""

from __future__ import annotations

from minipov.tracer.node import node, replace
from minipov.tracer.pattern import PLAIN, Pattern, PatternModifiers
from minipov.tracer.pigment import ColorMap
from minipov.tracer.transform import IDENTITY, Transform
from minipov.tracer.values import BLACK, WHITE, Rgb


@node
class DensityMap:
    """``density_map { [F density] ... }``."""

    entries: tuple[tuple[float, Density], ...]


@node
class DensityList:
    """The densities of a block pattern, one per kind of block."""

    densities: tuple[Density, ...]


@node
class Density:
    """A factor at every point of space; without a pattern it is ``color`` everywhere."""

    color: Rgb = WHITE
    pattern: Pattern | None = None
    blend: ColorMap | DensityMap | DensityList | None = None
    modifiers: PatternModifiers = PLAIN

    def transformed(self, transform: Transform) -> Density:
        """The same density, moved."""
        return self if transform is IDENTITY else replace(self, modifiers=self.modifiers.transformed(transform))


@node
class Scattering:
    """``scattering { kind, color eccentricity F extinction F }``, kind 1..5."""

    kind: int
    color: Rgb
    eccentricity: float = 0.0
    extinction: float = 1.0


@node
class Media:
    """``media { ... }``: what light meets on its way through a volume; densities multiply."""

    method: int = 3
    intervals: int = 1
    samples: tuple[int, int] = (10, 10)
    aa_threshold: float = 0.1
    aa_level: int = 3
    confidence: float = 0.9
    variance: float = 1 / 128
    ratio: float = 0.9
    jitter: float = 0.0
    absorption: Rgb = BLACK
    emission: Rgb = BLACK
    scattering: Scattering | None = None
    densities: tuple[Density, ...] = ()
    collect: bool = True

    def transformed(self, transform: Transform) -> Media:
        """The same media, moved."""
        return replace(self, densities=tuple(d.transformed(transform) for d in self.densities))


@node
class Interior:
    """What fills an object. ``fade_power`` 0 switches attenuation off.

    ``refraction`` is said by finishes of old scenes only: the share of light from behind a surface that is seen.
    ``caustics`` is the power of the cosine by which light gathers in shadows; 0: it does not.
    """

    ior: float = 1.0
    dispersion: float = 1.0
    dispersion_samples: int = 7
    caustics: float = 0.0
    refraction: float = 1.0
    fade_distance: float = 0.0
    fade_power: float = 0.0
    fade_color: Rgb = BLACK
    media: tuple[Media, ...] = ()

    def transformed(self, transform: Transform) -> Interior:
        """The same interior, moved; itself where there is nothing to move, so that shared interiors stay shared."""
        if not self.media or transform is IDENTITY:
            return self
        return replace(self, media=tuple(m.transformed(transform) for m in self.media))
