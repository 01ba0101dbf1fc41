"""SDL: ``union``, ``intersection``, ``difference``, ``merge``, ``object``, ``light_group``; clipping and bounding."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from minipov.interpreter.constructs.common import expect_end, unexpected
from minipov.interpreter.constructs.modifiers import MODIFIERS, SHAPE_SWITCHES, read_modifiers
from minipov.interpreter.constructs.shape import source_of
from minipov.interpreter.constructs.transforms import TRANSFORM_WORDS, read_transform, read_transforms
from minipov.interpreter.context import Context
from minipov.interpreter.errors import SdlError
from minipov.interpreter.items import Block, Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer import shapes
from minipov.tracer.lights import LightSource
from minipov.tracer.node import replace
from minipov.tracer.objects import Intersection, LightGroup, Merge, Object, Shape, Union

PATCHES: Final = (
    shapes.Triangle,
    shapes.SmoothTriangle,
    shapes.Polygon,
    shapes.BicubicPatch,
    shapes.Disc,
    shapes.Parametric,
)


@dataclass(slots=True)
class Members:
    """What a group consists of, in source order."""

    objects: list[Object]
    lights: list[LightSource]


def read_members(reader: ItemReader) -> Members:
    """The objects and lights at the start of a group."""
    members = Members([], [])
    while True:
        if (thing := reader.node(Object)) is not None:
            members.objects.append(thing)
        elif (light := reader.node(LightSource)) is not None:
            members.lights.append(light)
        else:
            return members


def has_inside(thing: Object) -> bool:
    """Whether points can lie inside: not so for patches and meshes without an inside_vector."""
    if isinstance(thing.shape, shapes.Mesh):
        return thing.shape.inside_vector is not None
    return not isinstance(thing.shape, PATCHES)


def _group(
    reader: ItemReader, context: Context, sink: Sink, make: Callable[[Members], Shape], *, solid: bool
) -> Object:
    place = reader.place
    members = read_members(reader)
    if len(members.objects) + len(members.lights) < 2:
        context.messages.warn(f"{reader.name} should have at least 2 objects", place)
    if solid and not all(has_inside(thing) for thing in members.objects):
        context.messages.warn(f"patch objects have no inside and do not belong in {reader.name}", place)
    thing = Object(make(members), source=source_of(sink))
    return read_modifiers(reader, context, thing)


def inverted(thing: Object) -> Object:
    """The object with inside and outside exchanged."""
    return replace(thing, modifiers=replace(thing.modifiers, inverse=not thing.modifiers.inverse))


@construct(
    "union",
    "composite",
    signature="objects and lights [split_union B] [modifiers]",
    doc="Several objects as one; surfaces inside it stay.",
    accepts=("split_union", *MODIFIERS),
)
def union(reader: ItemReader, context: Context, sink: Sink) -> Object:
    return _group(reader, context, sink, lambda m: Union(tuple(m.objects), tuple(m.lights)), solid=False)


@construct(
    "merge",
    signature="objects [modifiers]",
    doc="Several objects as one, without the surfaces inside it.",
    accepts=MODIFIERS,
)
def merge(reader: ItemReader, context: Context, sink: Sink) -> Object:
    return _group(reader, context, sink, lambda m: Merge(tuple(m.objects), tuple(m.lights)), solid=True)


@construct(
    "intersection",
    signature="objects [cutaway_textures] [modifiers]",
    doc="What all of the objects have in common.",
    accepts=("cutaway_textures", *MODIFIERS),
)
def intersection(reader: ItemReader, context: Context, sink: Sink) -> Object:
    return _group(reader, context, sink, lambda m: Intersection(tuple(m.objects), tuple(m.lights)), solid=True)


@construct(
    "difference",
    signature="object, objects [cutaway_textures] [modifiers]",
    doc="The first object without the others.",
    accepts=("cutaway_textures", *MODIFIERS),
)
def difference(reader: ItemReader, context: Context, sink: Sink) -> Object:
    def make(members: Members) -> Shape:
        first, rest = members.objects[:1], members.objects[1:]
        return Intersection((*first, *map(inverted, rest)), tuple(members.lights))

    return _group(reader, context, sink, make, solid=True)


@construct(
    "object",
    signature="object or identifier [modifiers]",
    doc="A declared object (or light), to be changed and placed.",
    accepts=(*MODIFIERS, *SHAPE_SWITCHES),
)
def object_(reader: ItemReader, context: Context, sink: Sink) -> Object | LightSource:
    light = reader.node(LightSource)
    if light is not None:
        return light.transformed(read_transforms(reader, context))
    thing = reader.node(Object)
    if thing is None:
        reader.fail("an object")
    return read_modifiers(reader, context, thing)


@construct(
    "light_group",
    signature="lights and objects [global_lights B] [transformations]",
    doc="Lights that shine on the objects of the group alone.",
    accepts=("global_lights", *TRANSFORM_WORDS),
)
def light_group(reader: ItemReader, context: Context, sink: Sink) -> Object:
    members = read_members(reader)
    group = LightGroup(tuple(members.objects), tuple(members.lights))
    thing = Object(group, source=source_of(sink))
    while not reader.at_end:
        transform = read_transform(reader, context)
        if transform is not None:
            thing = thing.transformed(transform)
        elif reader.word("global_lights"):
            group = replace(group, global_lights=reader.boolean())
            thing = replace(thing, shape=group)
        else:
            unexpected(reader, (*TRANSFORM_WORDS, "global_lights"))
    return thing


def _clip(name: str, other: str) -> None:
    @construct(
        name,
        signature=f"objects [transformations] | {other}",
        doc=(
            "Objects outside of which the object is cut away, without closing the cut."
            if name == "clipped_by"
            else "An object known to contain this one; wrong bounds cut it."
        ),
        accepts=(*TRANSFORM_WORDS, other),
    )
    def read(reader: ItemReader, context: Context, sink: Sink) -> Block:
        if reader.word(other):
            expect_end(reader)
            return Block(name, other)
        things: list[Object] = []
        while not reader.at_end:
            thing = reader.node(Object)
            if thing is not None:
                if not is_clip(thing):
                    raise SdlError(f"{name}: the object must be solid and without texture", sink.place)
                things.append(thing)
                continue
            transform = read_transform(reader, context)
            if transform is None:
                unexpected(reader, (*TRANSFORM_WORDS, other))
            things = [thing.transformed(transform) for thing in things]
        if not things:
            reader.fail("an object")
        return Block(name, tuple(things))


def is_clip(thing: Object) -> bool:
    """Whether an object may clip: solid and without a texture of its own."""
    if thing.texture is not None or not has_inside(thing):
        return False
    children = thing.shape.children if isinstance(thing.shape, Union | Merge | Intersection) else ()
    return all(map(is_clip, children))


_clip("clipped_by", "bounded_by")
_clip("bounded_by", "clipped_by")
