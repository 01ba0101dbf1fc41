"""SDL: ``finish { ambient 0.1 diffuse 0.7 phong 1 reflection { 0.1, 0.6 fresnel } }``."""

from __future__ import annotations

from minipov.tracer.node import node
from minipov.tracer.values import BLACK, Rgb


@node
class Reflection:
    """``reflection { minimum, maximum fresnel falloff F exponent F metallic F }``: minimum head-on, maximum grazing."""

    minimum: Rgb = BLACK
    maximum: Rgb = BLACK
    fresnel: bool = False
    falloff: float = 1.0
    exponent: float = 1.0
    metallic: float = 0.0


@node
class Iridescence:
    """``irid { amount thickness F turbulence F }``."""

    amount: float
    thickness: float = 0.0
    turbulence: float = 0.0


@node
class Subsurface:
    """``subsurface { translucency C anisotropy C }``."""

    translucency: Rgb
    anisotropy: Rgb = BLACK


@node
class Finish:
    """How a surface answers light; the defaults are those of ``#version 3.7``.

    ``*_albedo`` says that the keyword ``albedo`` stood before the number. ``fresnel`` and ``use_alpha`` are 3.8.
    """

    ambient: Rgb = (0.1, 0.1, 0.1)
    emission: Rgb = BLACK
    diffuse: float = 0.6
    diffuse_back: float = 0.0
    diffuse_albedo: bool = False
    brilliance: float = 1.0
    crand: float = 0.0
    phong: float = 0.0
    phong_albedo: bool = False
    phong_size: float = 40.0
    specular: float = 0.0
    specular_albedo: bool = False
    roughness: float = 0.05
    metallic: float = 0.0
    reflection: Reflection = Reflection()
    conserve_energy: bool = False
    irid: Iridescence | None = None
    subsurface: Subsurface | None = None
    fresnel: float = 0.0
    use_alpha: bool = False
