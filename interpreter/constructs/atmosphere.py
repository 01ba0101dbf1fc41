"""SDL: ``background { rgb 0.5 }``, ``fog {...}``, ``rainbow {...}``, ``sky_sphere { pigment {...} }``."""

from __future__ import annotations

import math
from dataclasses import fields
from typing import Any, Final

from minipov.interpreter.constructs.common import (
    Field,
    expect_end,
    integer,
    number,
    read_fields,
    unexpected,
    unread,
    vector,
)
from minipov.interpreter.constructs.pigment import read_pigment
from minipov.interpreter.constructs.transforms import TRANSFORM_WORDS, read_transform
from minipov.interpreter.constructs.warps import TURBULENCE_FIELDS
from minipov.interpreter.context import Context
from minipov.interpreter.items import Block, Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.atmosphere import Fog, Rainbow, SkySphere
from minipov.tracer.node import replace
from minipov.tracer.pigment import ColorMap, Pigment
from minipov.tracer.values import OPAQUE_BLACK, Vec3
from minipov.tracer.warp import Turbulence


@construct("background", signature="color", doc="The colour where nothing is.")
def background(reader: ItemReader, context: Context, sink: Sink) -> Block:
    color = reader.color()
    expect_end(reader)
    return Block("background", color)


FOG_FIELDS: Final[dict[str, Field]] = {
    "fog_type": integer("fog_type"),
    "distance": number("distance"),
    "fog_offset": number("fog_offset"),
    "fog_alt": number("fog_alt"),
    "turb_depth": number("turb_depth"),
    "up": vector("up"),
}
FOG_ACCEPTS: Final = (*FOG_FIELDS, *TURBULENCE_FIELDS, *TRANSFORM_WORDS, "color", "rgb", "rgbf", "rgbt", "rgbft")


@construct(
    "fog",
    signature="[identifier] [fog_type 1|2] distance F color C [fog_offset F fog_alt F] [turbulence V]",
    doc="Haze everywhere, or (type 2) near the ground.",
    accepts=FOG_ACCEPTS,
    node=Fog,
)
def fog(reader: ItemReader, context: Context, sink: Sink) -> Fog:
    result = reader.node(Fog) or Fog(0.0, OPAQUE_BLACK)
    while not reader.at_end:
        said = read_fields(reader, FOG_FIELDS)
        if said is not None:
            result = replace(result, **said)
            continue
        turbulent = read_fields(reader, TURBULENCE_FIELDS)
        if turbulent is not None:
            turbulence = result.turbulence or Turbulence((0.0, 0.0, 0.0))
            result = replace(result, turbulence=replace(turbulence, **turbulent))
            continue
        place = reader.place
        transform = read_transform(reader, context)
        if transform is not None:
            if transform.direction((0.0, 0.0, 0.0)) != transform.point((0.0, 0.0, 0.0)):
                context.messages.warn_once("fog translate", "a fog cannot be translated: ignored", place)
            result = replace(result, up=transform.direction(result.up))
        elif reader.is_color() or reader.is_number():
            result = replace(result, color=reader.color())
        else:
            unexpected(reader, FOG_ACCEPTS)
    if result.fog_type not in (1, 2):
        reader.refuse("fog_type 1 or 2")
    return result


COLLINEAR: Final = 1e-6
"""Vectors whose cross product is smaller, for unit length, count as parallel."""

RAINBOW_FIELDS: Final[dict[str, Field]] = {
    "direction": vector("direction"),
    "angle": number("angle"),
    "width": number("width"),
    "distance": number("distance"),
    "jitter": number("jitter"),
    "up": vector("up"),
    "arc_angle": number("arc_angle"),
    "falloff_angle": number("falloff_angle"),
}
RAINBOW_ACCEPTS: Final = (*RAINBOW_FIELDS, "color_map", "colour_map")


@construct(
    "rainbow",
    signature="[identifier] direction V angle F width F color_map {} [distance F] [arc_angle F] [falloff_angle F]",
    doc="A bow of light opposite to a direction.",
    accepts=RAINBOW_ACCEPTS,
    node=Rainbow,
)
def rainbow(reader: ItemReader, context: Context, sink: Sink) -> Rainbow:
    named = reader.node(Rainbow)
    said: dict[str, Any] = {} if named is None else _kept(named)
    while not reader.at_end:
        read = read_fields(reader, RAINBOW_FIELDS)
        if read is not None:
            said.update(read)
            continue
        colors = reader.node(ColorMap)
        if colors is None:
            unexpected(reader, RAINBOW_ACCEPTS)
        said["color_map"] = colors
    if "direction" not in said:
        reader.refuse("'direction' somewhere in the rainbow")
    result = Rainbow(**said)
    _check_angles(result, reader)
    return result


def _check_angles(bow: Rainbow, reader: ItemReader) -> None:
    if _collinear(bow.direction, bow.up):
        reader.refuse("a direction that differs from 'up'")
    for word, angle in (("arc_angle", bow.arc_angle), ("falloff_angle", bow.falloff_angle)):
        if not (0.0 <= angle <= 360.0 or angle == math.inf):
            reader.refuse(f"{word} from 0 to 360")
    if bow.arc_angle < bow.falloff_angle < math.inf:
        reader.refuse("an arc_angle that is not smaller than falloff_angle")


def _collinear(a: Vec3, b: Vec3) -> bool:
    cross = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    return math.hypot(*cross) <= COLLINEAR * math.hypot(*a) * math.hypot(*b)


def _kept(named: Rainbow) -> dict[str, Any]:
    """What a rainbow takes over from a declared one. POV-Ray takes the angles, which it has already in radians from the
    bow's inner edge on, for degrees from its middle on (probed)."""
    kept = {field.name: getattr(named, field.name) for field in fields(named)}
    inner = math.radians(named.angle - named.width / 2.0)
    return kept | {"angle": inner, "width": math.radians(named.width)}


SKY_ACCEPTS: Final = ("pigment", "emission", *TRANSFORM_WORDS)


@construct(
    "sky_sphere",
    signature="[identifier] pigment {} [pigment {} ...] [emission C] [transformations]",
    doc="The colour where nothing is, by direction; several pigments are layers.",
    accepts=SKY_ACCEPTS,
    node=SkySphere,
)
def sky_sphere(reader: ItemReader, context: Context, sink: Sink) -> SkySphere:
    result = reader.node(SkySphere) or SkySphere(())
    while not reader.at_end:
        items = unread(reader, "pigment")
        if items is not None:
            result = replace(result, pigments=(*result.pigments, read_pigment(items, context, Pigment())))
            continue
        transform = read_transform(reader, context)
        if transform is not None:
            moved = tuple(pigment.transformed(transform) for pigment in result.pigments)
            result = replace(result, pigments=moved)
        elif reader.word("emission"):
            result = replace(result, emission=reader.rgb())
        else:
            unexpected(reader, SKY_ACCEPTS)
    if not result.pigments:
        reader.fail("a pigment")
    return result
