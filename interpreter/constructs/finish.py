"""SDL: ``finish { ambient 0.1 diffuse albedo 0.7 phong 1 reflection { 0.1, 0.6 fresnel } }``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields
from typing import Any, Final

from minipov.interpreter.constructs.common import (
    Field,
    boolean,
    number,
    read_all_fields,
    read_fields,
    rgb,
    switch,
    unexpected,
)
from minipov.interpreter.context import Context
from minipov.interpreter.items import Block, Sink, Unread
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.finish import Finish, Iridescence, Reflection, Subsurface
from minipov.tracer.interior import Interior
from minipov.tracer.node import node, replace
from minipov.tracer.objects import Object
from minipov.tracer.texture import LayeredTexture, PlainTexture, Texture
from minipov.tracer.values import BLACK

NO_INTERIOR: Final = Interior()


@node
class OldFinish(Finish):
    """A finish that also says what belongs in the interior, as scenes did before version 3.1."""

    interior: Interior = NO_INTERIOR


def _diffuse(reader: ItemReader) -> dict[str, Any]:
    found: dict[str, Any] = {"diffuse_albedo": reader.word("albedo") is not None, "diffuse": reader.float()}
    if reader.is_number():
        found["diffuse_back"] = reader.float()
    return found


def _highlight(name: str) -> Field:
    return lambda reader: {f"{name}_albedo": reader.word("albedo") is not None, name: reader.float()}


def optional_number(field: str) -> Field:
    """``word [F]``: missing means 1."""
    return lambda reader: {field: reader.float() if reader.is_number() else 1.0}


FINISH_FIELDS: Final[dict[str, Field]] = {
    "ambient": rgb("ambient"),
    "emission": rgb("emission"),
    "diffuse": _diffuse,
    "brilliance": number("brilliance"),
    "crand": number("crand"),
    "phong": _highlight("phong"),
    "phong_size": number("phong_size"),
    "specular": _highlight("specular"),
    "roughness": number("roughness"),
    "metallic": optional_number("metallic"),
    "conserve_energy": switch("conserve_energy"),
    "fresnel": optional_number("fresnel"),
    "use_alpha": boolean("use_alpha"),
}
OLD_FIELDS: Final[dict[str, Field]] = {
    "ior": number("ior"),
    "caustics": number("caustics"),
    "fade_distance": number("fade_distance"),
    "fade_power": number("fade_power"),
    "refraction": number("refraction"),
}
REFLECTION_FIELDS: Final[dict[str, Field]] = {
    "fresnel": boolean("fresnel"),
    "falloff": number("falloff"),
    "exponent": number("exponent"),
    "metallic": optional_number("metallic"),
}


def read_finish(reader: ItemReader, context: Context, base: Finish) -> Finish:
    """``base`` with what a finish block says."""
    finish = reader.node(Finish) or base
    changes: dict[str, Any] = {}
    old: dict[str, Any] = {}
    reflection = finish.reflection
    while not reader.at_end:
        place = reader.place
        read = read_fields(reader, FINISH_FIELDS)
        if read is not None:
            changes.update(read)
            continue
        read = read_fields(reader, OLD_FIELDS)
        if read is not None:
            context.messages.warn_once("finish interior", f"'{next(iter(read))}' belongs in interior", place)
            old.update(read)
            continue
        block = reader.node(Block)
        if block is not None and block.name in ("reflection", "irid", "subsurface"):
            changes[block.name] = block.value
            reflection = changes.get("reflection", reflection)
        elif reader.word("reflection"):
            color = reader.rgb()
            changes["reflection"] = reflection = replace(reflection, minimum=color, maximum=color)
        elif reader.word("reflection_exponent"):
            changes["reflection"] = reflection = replace(reflection, exponent=reader.float())
        elif reader.word("irid"):
            changes["irid"] = Iridescence(reader.float())
        else:
            unexpected(reader, (*FINISH_FIELDS, *OLD_FIELDS, "reflection", "reflection_exponent", "irid", "subsurface"))
    if changes.get("roughness", 1.0) == 0.0:
        context.messages.warn("roughness 0: specular highlights vanish", reader.place)
    if old:
        finish = _old_style(finish, old)
    return replace(finish, **changes) if changes else finish


def _old_style(finish: Finish, said: dict[str, Any]) -> OldFinish:
    """The finish with interior items put away for the object to take."""
    interior = finish.interior if isinstance(finish, OldFinish) else Interior()
    if said.get("refraction", 1.0) <= 0.0:
        said.pop("ior", None)
    plain = {field.name: getattr(finish, field.name) for field in fields(Finish)}
    return OldFinish(**plain, interior=replace(interior, **said))


def with_old_interior(thing: Object) -> Object:
    """The object with the interior that its finishes describe, where it has none of its own."""
    if thing.interior is None and thing.texture is not None:
        for finish in _finishes(thing.texture):
            if isinstance(finish, OldFinish):
                return replace(thing, interior=finish.interior)
    return thing


def _finishes(texture: Texture) -> Sequence[Finish]:
    if isinstance(texture, PlainTexture):
        return (texture.finish,)
    return [layer.finish for layer in texture.layers] if isinstance(texture, LayeredTexture) else ()


@construct(
    "finish",
    signature="[identifier] items",
    doc="How a surface answers light: ambient and diffuse shares, highlights, reflection, iridescence.",
    accepts=(*FINISH_FIELDS, *OLD_FIELDS, "reflection", "reflection_exponent", "irid", "subsurface", "albedo"),
    node=Finish,
)
def finish(reader: ItemReader, context: Context, sink: Sink) -> Unread:
    return Unread("finish", reader, lambda items: read_finish(items, context, default_finish(context)))


def default_finish(context: Context) -> Finish:
    """The finish of the default texture."""
    default = context.default_texture
    return default.finish if isinstance(default, PlainTexture) else Finish()


@construct(
    "reflection",
    within=("finish",),
    signature="color [, color] [fresnel B] [falloff F] [exponent F] [metallic F]",
    doc="Mirror reflection: one colour at all angles, or one straight on and one at grazing angles.",
    accepts=tuple(REFLECTION_FIELDS),
    node=Reflection,
)
def reflection(reader: ItemReader, context: Context, sink: Sink) -> Block:
    first = second = BLACK
    pair = False
    if reader.is_number() or reader.is_color():
        first = second = reader.rgb()
        reader.comma()
        pair = reader.is_number() or reader.is_color()
        if pair:
            second = reader.rgb()
    said = read_all_fields(reader, REFLECTION_FIELDS)
    if said.get("fresnel") and not pair:
        first = BLACK
    return Block("reflection", Reflection(first, second, **said))


@construct(
    "irid",
    within=("finish",),
    signature="F [thickness F] [turbulence F]",
    doc="Iridescence, as of a thin film of oil.",
    accepts=("thickness", "turbulence"),
    node=Iridescence,
)
def irid(reader: ItemReader, context: Context, sink: Sink) -> Block:
    amount = reader.float()
    table = {"thickness": number("thickness"), "turbulence": number("turbulence")}
    return Block("irid", Iridescence(amount, **read_all_fields(reader, table)))


@construct(
    "subsurface",
    within=("finish",),
    signature="translucency C [anisotropy C]",
    doc="Light that enters the surface and leaves it elsewhere.",
    accepts=("translucency", "anisotropy"),
)
def subsurface(reader: ItemReader, context: Context, sink: Sink) -> Block:
    table = {"translucency": rgb("translucency"), "anisotropy": rgb("anisotropy")}
    said = read_all_fields(reader, table)
    return Block("subsurface", Subsurface(**{"translucency": BLACK, **said}))
