"""A whole scene: what the interpreter makes and the core renders."""

from __future__ import annotations

from minipov.tracer.atmosphere import Fog, Rainbow, SkySphere
from minipov.tracer.camera import Camera
from minipov.tracer.interior import Media
from minipov.tracer.lights import LightSource
from minipov.tracer.node import node
from minipov.tracer.objects import Object
from minipov.tracer.settings import GlobalSettings
from minipov.tracer.texture import PlainTexture, Texture
from minipov.tracer.values import Rgbft


@node
class Scene:
    """Objects, lights and surroundings, in source order. ``version`` is the scene's ``#version``.

    ``default_texture`` dresses objects that have none of their own nor a parent's.
    """

    objects: tuple[Object, ...] = ()
    lights: tuple[LightSource, ...] = ()
    camera: Camera = Camera()
    background: Rgbft = (0.0, 0.0, 0.0, 0.0, 1.0)
    fogs: tuple[Fog, ...] = ()
    rainbows: tuple[Rainbow, ...] = ()
    sky_sphere: SkySphere | None = None
    media: tuple[Media, ...] = ()
    settings: GlobalSettings = GlobalSettings()
    default_texture: Texture = PlainTexture()
    version: float = 3.7
