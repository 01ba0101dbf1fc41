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
from minipov.tracer.texture import PlainTexture

ACCEPTS: Final = ("texture", "pigment", "normal", "finish", "radiosity", "camera")


@construct(
    "#default",
    signature="texture | pigment | normal | finish | radiosity { importance F } | camera",
    doc="What objects wear, and what textures start from, unless they say otherwise.",
    accepts=ACCEPTS,
)
def default(reader: ItemReader, context: Context, sink: Sink) -> None:
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
