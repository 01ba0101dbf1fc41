"""SDL: ``#default { texture {...} }``, or ``pigment``, ``normal``, ``finish``, ``radiosity``, ``camera``."""

from __future__ import annotations

from typing import Final

from minipov.interpreter.constructs.common import unexpected
from minipov.interpreter.constructs.texture import TEXTURE_TYPES, modified_texture
from minipov.interpreter.context import Context
from minipov.interpreter.items import Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.camera import Camera
from minipov.tracer.finish import Finish
from minipov.tracer.pigment import Pigment
from minipov.tracer.texture import PlainTexture
from minipov.tracer.values import BLACK

WHITE_SINCE: Final = 3.8
WHITE_AND_DARK: Final = PlainTexture(Pigment((1.0, 1.0, 1.0, 0.0, 0.0)), None, Finish(ambient=BLACK))
"""The default texture since version 3.8: white, without ambient light."""

ACCEPTS: Final = ("texture", "pigment", "normal", "finish", "radiosity", "camera")


def set_version(context: Context, version: float) -> None:
    """``#version``: until the first ``#default``, the default texture follows it."""
    context.version = version
    context.version_was_set = True
    if not context.default_was_set:
        context.default_texture = WHITE_AND_DARK if version >= WHITE_SINCE else PlainTexture()


@construct(
    "#default",
    signature="texture | pigment | normal | finish | radiosity { importance F } | camera",
    doc="What objects wear, and what textures start from, unless they say otherwise.",
    accepts=ACCEPTS,
)
def default(reader: ItemReader, context: Context, sink: Sink) -> None:
    context.default_was_set = True
    while not reader.at_end:
        texture = reader.node(TEXTURE_TYPES)
        if texture is not None:
            if not isinstance(texture, PlainTexture):
                reader.refuse("a plain texture as the default", "no layers, no patterns of textures")
            context.default_texture = texture
            continue
        changed = modified_texture(reader, context, context.default_texture)
        if changed is not None:
            context.default_texture = changed
            continue
        importance = reader.block("radiosity")
        if importance is not None:
            context.default_radiosity_importance = importance
            continue
        camera = reader.node(Camera)
        if camera is None:
            unexpected(reader, ACCEPTS)
        context.default_camera = camera
