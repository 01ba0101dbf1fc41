"""The scene that is left when every file has been read: what depends on the whole of it."""

from __future__ import annotations

from typing import Final

from minipov.interpreter.constructs.camera import plain_camera
from minipov.interpreter.constructs.gamma import GAMMA_VERSION, working_gamma
from minipov.interpreter.context import Context
from minipov.tracer.node import replace
from minipov.tracer.scene import Scene
from minipov.tracer.values import Rgbft

CLEAR_BLACK: Final[Rgbft] = (0.0, 0.0, 0.0, 0.0, 1.0)


def finished(context: Context) -> Scene:
    """The scene to render; warns of what is missing in it."""
    found = context.scene
    if not context.scene.gamma_was_set:
        context.messages.warn_once("gamma", _NO_GAMMA[context.version >= GAMMA_VERSION])
    if not found.objects and not found.lights:
        context.messages.warn("no objects in the scene")
    return Scene(
        tuple(found.objects),
        tuple(found.lights),
        found.camera or plain_camera(context),
        _background(context),
        tuple(found.fogs),
        tuple(found.rainbows),
        found.sky_sphere,
        tuple(found.media),
        replace(found.settings, assumed_gamma=working_gamma(context), noise_generator=context.noise_generator),
        context.default_texture,
        context.version,
    )


_NO_GAMMA: Final = {
    True: "assumed_gamma is not set: 1.0 taken",
    False: "assumed_gamma is not set: no gamma correction, as before version 3.7",
}


def _background(context: Context) -> Rgbft:
    """Before version 3.7 a background was opaque."""
    color = context.scene.background
    if color is None:
        return CLEAR_BLACK
    return color if context.version >= GAMMA_VERSION else (*color[:3], 0.0, 0.0)
