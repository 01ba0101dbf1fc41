"""What a complete value does when it stands by itself in a file: objects and lights join the scene, and so on."""

from __future__ import annotations

from minipov.interpreter.context import Context
from minipov.interpreter.errors import Place, SdlError
from minipov.interpreter.items import Block, Item, complete
from minipov.interpreter.reader import describe
from minipov.tracer import objects
from minipov.tracer.atmosphere import Fog, Rainbow, SkySphere
from minipov.tracer.camera import Camera
from minipov.tracer.interior import Media
from minipov.tracer.lights import LightSource
from minipov.tracer.node import replace
from minipov.tracer.objects import Object


def instantiate(item: Item, place: Place, context: Context) -> None:
    """Take ``item``, pushed at top level, into the scene.

    Raises:
        SdlError: it cannot stand there.
    """
    scene = context.scene
    match complete(item):
        case Object() as thing:
            scene.objects.append(dressed(thing, context))
        case LightSource() as light:
            looks = light.looks_like
            scene.lights.append(replace(light, looks_like=looks and dressed(looks, context)))
        case Camera() as camera:
            if scene.camera is not None:
                context.messages.warn("several cameras: the last one counts", place)
            scene.camera = camera
        case Fog() as fog:
            scene.fogs.append(fog)
        case Rainbow() as rainbow:
            scene.rainbows.append(rainbow)
        case Media() as media:
            scene.media.append(media)
        case SkySphere() as sky:
            if scene.sky_sphere is not None:
                context.messages.warn("several sky_sphere: the last one counts", place)
            scene.sky_sphere = sky
        case Block("background", color):
            scene.background = color
        case None | Block("global_settings"):
            pass
        case other:
            raise SdlError(f"expected an object or a directive, found {describe(other)}", place)


def dressed(thing: Object, context: Context) -> Object:
    """The object in the default texture of this moment where it has none (children wear their parent's)."""
    if thing.texture is not None:
        return thing
    if isinstance(thing.shape, objects.Intersection) and thing.shape.cutaway_textures:
        return thing
    return replace(thing, texture=context.default_texture)
