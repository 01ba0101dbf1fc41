"""SDL: ``material { texture {...} interior_texture {...} interior {...} scale 2 }``: looks and filling together."""

from __future__ import annotations

from minipov.interpreter.constructs.common import unexpected
from minipov.interpreter.constructs.texture import TEXTURE_TYPES, layered, read_texture
from minipov.interpreter.constructs.transforms import TRANSFORM_WORDS, read_transform
from minipov.interpreter.context import Context
from minipov.interpreter.items import Block, Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.interior import Interior
from minipov.tracer.node import node, replace
from minipov.tracer.texture import Texture
from minipov.tracer.transform import Transform


@node
class Material:
    """A texture, the texture of the inner side, and an interior; None where not said."""

    texture: Texture | None = None
    interior_texture: Texture | None = None
    interior: Interior | None = None

    def transformed(self, transform: Transform) -> Material:
        """The same material, moved."""
        return Material(
            self.texture and self.texture.transformed(transform),
            self.interior_texture and self.interior_texture.transformed(transform),
            self.interior and self.interior.transformed(transform),
        )


ACCEPTS = ("texture", "interior_texture", "interior", *TRANSFORM_WORDS)


@construct(
    "material",
    signature="[identifier] [texture] [interior_texture] [interior] [transformations]",
    doc="A texture and an interior that belong together, to be declared and used again.",
    accepts=ACCEPTS,
)
def material(reader: ItemReader, context: Context, sink: Sink) -> Material:
    result = reader.node(Material) or Material()
    while not reader.at_end:
        texture = reader.node(TEXTURE_TYPES)
        if texture is not None:
            result = replace(result, texture=layered(result.texture, texture, reader))
            continue
        inner = reader.block("interior_texture")
        if inner is not None:
            result = replace(result, interior_texture=layered(result.interior_texture, inner, reader))
            continue
        interior = reader.node(Interior)
        if interior is not None:
            result = replace(result, interior=interior)
            continue
        transform = read_transform(reader, context)
        if transform is None:
            unexpected(reader, ACCEPTS)
        result = result.transformed(transform)
    return result


@construct(
    "interior_texture",
    signature="like texture",
    doc="The texture of an object's inner side.",
)
def interior_texture(reader: ItemReader, context: Context, sink: Sink) -> Block:
    return Block("interior_texture", read_texture(reader, context))
