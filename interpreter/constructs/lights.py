"""SDL: ``light_source { <0,10,0>, rgb 1 spotlight point_at 0 radius 20 falloff 30 area_light x, y, 4, 4 }``."""

from __future__ import annotations

from typing import Any, Final

from minipov.interpreter.constructs.common import (
    Field,
    boolean,
    count,
    number,
    read_all_fields,
    read_fields,
    required_boolean,
    switch,
    unexpected,
)
from minipov.interpreter.constructs.modifiers import MODIFIERS, read_modifiers
from minipov.interpreter.constructs.transforms import TRANSFORM_WORDS, read_transform
from minipov.interpreter.context import Context
from minipov.interpreter.items import Block, Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.lights import AreaLight, LightPhotons, LightSource
from minipov.tracer.node import replace
from minipov.tracer.objects import Object
from minipov.tracer.transform import Transform
from minipov.tracer.values import BLACK

LIGHT_FIELDS: Final[dict[str, Field]] = {
    "shadowless": switch("shadowless"),
    "fade_distance": number("fade_distance"),
    "fade_power": number("fade_power"),
    "media_interaction": boolean("media_interaction"),
    "media_attenuation": boolean("media_attenuation"),
    "parallel": switch("parallel"),
}
SPOT_FIELDS: Final[dict[str, Field]] = {
    "point_at": lambda reader: {"point_at": reader.vector()},
    "radius": number("radius"),
    "falloff": number("falloff"),
    "tightness": number("tightness"),
}
AREA_FIELDS: Final[dict[str, Field]] = {
    "adaptive": count("adaptive", 20),
    "jitter": switch("jitter"),
    "circular": switch("circular"),
    "orient": switch("orient"),
    "area_illumination": boolean("area_illumination"),
}
ACCEPTS: Final = (
    *("spotlight", "cylinder", "area_light", "looks_like", "projected_through", "photons"),
    *LIGHT_FIELDS,
    *SPOT_FIELDS,
    *AREA_FIELDS,
    *TRANSFORM_WORDS,
)
MOST_LAMPS: Final = 1000
SPOTLIGHT_CONES: Final = (30.0, 45.0)
CYLINDER_RADII: Final = (0.75, 1.0)


@construct(
    "light_source",
    signature="location, color [spotlight|cylinder|parallel] [area_light V, V, I, I] [modifiers]",
    doc="A light: a point, a spot, a beam, or an area of points.",
    accepts=ACCEPTS,
    node=LightSource,
)
def light_source(reader: ItemReader, context: Context, sink: Sink) -> LightSource:
    light = reader.node(LightSource) or _plain_light(reader, context)
    area: dict[str, Any] = {}
    while not reader.at_end:
        fields = read_fields(reader, AREA_FIELDS)
        if fields is not None:
            area.update(fields)
            continue
        changed = _modified(reader, context, light)
        if changed is None:
            unexpected(reader, ACCEPTS)
        light = changed
    if light.area is None:
        return light
    grid = replace(light.area, **area)
    _check_area(grid, reader)
    return replace(light, area=grid)


def _plain_light(reader: ItemReader, context: Context) -> LightSource:
    place, location = reader.place, reader.vector()
    reader.comma()
    if reader.is_number() or reader.is_color():
        return LightSource(location, reader.rgb())
    context.messages.warn("light_source without a colour: black", place)
    return LightSource(location, BLACK)


def _modified(reader: ItemReader, context: Context, light: LightSource) -> LightSource | None:
    transform = read_transform(reader, context)
    if transform is not None:
        return light.transformed(transform)
    fields = read_fields(reader, LIGHT_FIELDS)
    if fields is not None:
        return replace(light, **fields)
    if light.kind != "point" or light.parallel:
        fields = read_fields(reader, SPOT_FIELDS)
        if fields is not None:
            return replace(light, **fields)
    kind = reader.word("spotlight", "cylinder")
    if kind == "spotlight":
        return replace(light, kind="spotlight", radius=SPOTLIGHT_CONES[0], falloff=SPOTLIGHT_CONES[1])
    if kind == "cylinder":
        return replace(light, kind="cylinder", radius=CYLINDER_RADII[0], falloff=CYLINDER_RADII[1])
    if reader.word("area_light"):
        return replace(light, area=_area_light(reader, light.area))
    return _with_block(reader, light)


def _area_light(reader: ItemReader, old: AreaLight | None) -> AreaLight:
    axis1, axis2 = reader.vector(), reader.vector()
    size1, size2 = _area_size(reader), _area_size(reader)
    if old is None:
        return AreaLight(axis1, axis2, size1, size2)
    return replace(old, axis1=axis1, axis2=axis2, size1=size1, size2=size2)


def _area_size(reader: ItemReader) -> int:
    """How many lamps stand along one axis; its sign does not matter."""
    size = abs(reader.count(MOST_LAMPS, -MOST_LAMPS))
    if size == 0:
        reader.refuse("an area_light of at least one lamp along each axis")
    return size


def _with_block(reader: ItemReader, light: LightSource) -> LightSource | None:
    looks = reader.block("looks_like")
    if looks is not None:
        if light.looks_like is not None:
            reader.refuse("one looks_like only")
        return replace(light, looks_like=looks.transformed(Transform.translate(light.location)))
    through = reader.block("projected_through")
    if through is not None:
        return replace(light, projected_through=through)
    photons = reader.block("photons")
    if photons is not None:
        return replace(light, photons=replace(light.photons or LightPhotons(), **photons))
    return None


def _check_area(area: AreaLight, reader: ItemReader) -> None:
    if area.circular and (area.size1 < 2 or area.size2 < 2):
        reader.refuse("an area_light of at least 2 by 2 for 'circular'")
    if area.orient and not (area.circular and area.size1 == area.size2):
        reader.refuse("a circular area_light with equal sizes for 'orient'")


def _single_object(reader: ItemReader) -> Object:
    thing = reader.node(Object)
    if thing is None:
        reader.fail("an object")
    return thing


@construct(
    "looks_like",
    signature="object [modifiers]",
    doc="What a light looks like; moved to the light, and without shadow.",
    accepts=MODIFIERS,
)
def looks_like(reader: ItemReader, context: Context, sink: Sink) -> Block:
    thing = read_modifiers(reader, context, _single_object(reader))
    return Block("looks_like", replace(thing, modifiers=replace(thing.modifiers, no_shadow=True)))


@construct(
    "projected_through",
    signature="object [modifiers]",
    doc="Only light that passes this object counts.",
    accepts=MODIFIERS,
)
def projected_through(reader: ItemReader, context: Context, sink: Sink) -> Block:
    return Block("projected_through", read_modifiers(reader, context, _single_object(reader)))


@construct(
    "photons",
    within=("light_source",),
    signature="[refraction B] [reflection B] [area_light]",
    doc="Which photons the light sends out.",
    accepts=("refraction", "reflection", "area_light"),
)
def light_photons(reader: ItemReader, context: Context, sink: Sink) -> Block:
    table = {
        "refraction": required_boolean("refraction"),
        "reflection": required_boolean("reflection"),
        "area_light": switch("area_light"),
    }
    said: dict[str, Any] = read_all_fields(reader, table)
    return Block("photons", said)
