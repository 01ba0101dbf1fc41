"""SDL: ``blob { threshold 0.6 sphere { 0, 1, 1 } cylinder { 0, y, 0.5, 1 } }``."""

from __future__ import annotations

from typing import Final

from minipov.interpreter.constructs.common import unexpected
from minipov.interpreter.constructs.shape import shape
from minipov.interpreter.constructs.texture import TEXTURE_TYPES, layered, modified_texture
from minipov.interpreter.constructs.transforms import TRANSFORM_WORDS, read_transform
from minipov.interpreter.context import Context
from minipov.interpreter.items import Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.objects import Shape
from minipov.tracer.shapes import Blob, BlobComponent
from minipov.tracer.texture import Texture
from minipov.tracer.transform import IDENTITY
from minipov.tracer.values import Vec3

COMPONENT_ACCEPTS: Final = ("strength", "texture", "pigment", "normal", "finish", *TRANSFORM_WORDS)


@shape(
    "blob",
    signature="[threshold F] sphere {} cylinder {} ... [sturm] [hierarchy B]",
    doc="Soft balls and rods that melt into each other where the sum of their fields exceeds the threshold.",
    accepts=("threshold", "component", "sphere", "cylinder", "sturm", "hierarchy"),
)
def blob(reader: ItemReader, context: Context) -> Shape:
    threshold = 1.0
    components: list[BlobComponent] = []
    while True:
        part = reader.node(BlobComponent)
        if part is not None:
            components.append(part)
        elif reader.word("threshold"):
            threshold = reader.float()
        elif reader.word("component"):
            strength, radius = reader.float(), reader.float()
            components.append(BlobComponent(reader.vector(), radius, strength))
        else:
            break
    if not components:
        reader.fail("at least one component", "write for example: sphere { 0, 1, 1 }")
    if threshold <= 0.0:
        context.messages.warn("blob threshold should be above 0", reader.place)
    return Blob(tuple(components), threshold)


@construct(
    "sphere",
    within=("blob",),
    signature="center, radius, [strength] F [texture] [transformations]",
    doc="A ball of a blob.",
    accepts=COMPONENT_ACCEPTS,
)
def blob_sphere(reader: ItemReader, context: Context, sink: Sink) -> BlobComponent:
    return _component(reader, context, reader.vector(), None)


@construct(
    "cylinder",
    within=("blob",),
    signature="end, end, radius, [strength] F [texture] [transformations]",
    doc="A rod of a blob, with round ends.",
    accepts=COMPONENT_ACCEPTS,
)
def blob_cylinder(reader: ItemReader, context: Context, sink: Sink) -> BlobComponent:
    return _component(reader, context, reader.vector(), reader.vector())


def _component(reader: ItemReader, context: Context, center: Vec3, end: Vec3 | None) -> BlobComponent:
    radius = reader.float()
    reader.comma()
    reader.word("strength")
    strength = reader.float()
    total = IDENTITY
    texture: Texture | None = None
    while not reader.at_end:
        transform = read_transform(reader, context)
        if transform is not None:
            total = total.then(transform)
            texture = texture and texture.transformed(transform)
            continue
        layer = reader.node(TEXTURE_TYPES)
        if layer is not None:
            texture = layered(texture, layer, reader)
            continue
        texture = modified_texture(reader, context, texture)
        if texture is None:
            unexpected(reader, COMPONENT_ACCEPTS)
    return BlobComponent(center, radius, strength, end, total, texture)
