"""SDL: ``normal { bumps 0.5 scale 0.1 }``, ``normal_map``, ``bump_map``."""

from __future__ import annotations

from typing import Final

from minipov.interpreter.constructs.common import unexpected, unread
from minipov.interpreter.constructs.maps import read_entries
from minipov.interpreter.constructs.pattern_modifiers import (
    PARAMETERS,
    PATTERN_MODIFIERS,
    read_named,
    read_pattern_modifier,
    read_pattern_parameter,
)
from minipov.interpreter.constructs.patterns import (
    PATTERN_WORDS,
    block_count,
    block_items,
    object_pattern,
    pattern_word,
    read_pattern,
)
from minipov.interpreter.context import Context
from minipov.interpreter.items import Sink, Unread
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.node import replace
from minipov.tracer.normal import Normal, NormalList, NormalMap, SlopeMap
from minipov.tracer.pattern import Pattern
from minipov.tracer.texture import PlainTexture

MAPS: Final[tuple[type[SlopeMap | NormalMap], ...]] = (SlopeMap, NormalMap)
ACCEPTS: Final = (
    *PATTERN_WORDS,
    *PATTERN_MODIFIERS,
    *PARAMETERS,
    *("facets", "bump_map", "bump_size", "accuracy", "no_bump_scale", "normal_map", "slope_map"),
)
SMOOTH: Final = Normal(None)


def default_normal(context: Context) -> Normal:
    """The normal of the default texture: what every normal block starts from."""
    default = context.default_texture
    return (default.normal if isinstance(default, PlainTexture) else None) or SMOOTH


def read_normal(reader: ItemReader, context: Context, base: Normal) -> Normal:
    """``base`` with what a normal block says."""
    normal = read_normal_body(reader, context, base)
    if not reader.at_end:
        unexpected(reader, ACCEPTS)
    return normal


def read_normal_body(reader: ItemReader, context: Context, base: Normal) -> Normal:
    """As `read_normal`, up to the first item that belongs to no normal."""
    normal = _read_kind(reader, context, read_named(reader, Normal, base))
    while not reader.at_end:
        changed = _modified(reader, context, normal)
        if changed is None:
            break
        normal = changed
    if normal.pattern is not None and normal.blend is None and pattern_word(normal.pattern) == "average":
        reader.refuse("a normal_map for 'average'")
    return normal


def _read_kind(reader: ItemReader, context: Context, base: Normal) -> Normal:
    """The pattern that must come first, and the depth of its bumps."""
    bump_map = reader.block("bump_map")
    if bump_map is not None:
        amount = base.amount if bump_map[1] is None else bump_map[1]
        return replace(base, pattern=bump_map[0], blend=None, amount=_amount(reader, amount))
    by_object = object_pattern(reader, context)
    if by_object is not None:
        return replace(base, pattern=by_object[0], blend=_block_list(by_object[1], context, by_object[0]))
    pattern = read_pattern(reader, context)
    if pattern is None:
        return base
    blocks = _block_list(reader, context, pattern)
    amount = _amount(reader, base.amount)
    keep = base.blend if isinstance(base.blend, SlopeMap | NormalMap) else None
    return replace(base, pattern=pattern, amount=amount, blend=blocks or keep)


def _amount(reader: ItemReader, default: float) -> float:
    """The depth of bumps that may follow a pattern."""
    return reader.float() if reader.is_number() else default


def _modified(reader: ItemReader, context: Context, normal: Normal) -> Normal | None:
    modifiers = read_pattern_modifier(reader, context, normal.modifiers)
    if modifiers is not None:
        return replace(normal, modifiers=modifiers)
    blend = reader.node(MAPS)
    if blend is not None:
        return replace(normal, blend=blend)
    if reader.word("bump_size"):
        return replace(normal, amount=reader.float())
    if reader.word("accuracy"):
        return replace(normal, accuracy=reader.float())
    if reader.word("no_bump_scale"):
        return replace(normal, no_bump_scale=reader.boolean())
    pattern = read_pattern_parameter(reader, normal.pattern)
    if pattern is not None:
        return replace(normal, pattern=pattern)
    return None


def _block_list(reader: ItemReader, context: Context, pattern: Pattern) -> NormalList | None:
    """The normals of a block pattern; those not given are smooth."""
    count = block_count(pattern)
    given = block_items(reader, count, lambda: _block_item(reader, context))
    return NormalList((*given, *[None] * (count - len(given)))) if given else None


def _block_item(reader: ItemReader, context: Context) -> Normal | None:
    inner = unread(reader, "normal")
    return reader.node(Normal) if inner is None else read_normal(inner, context, default_normal(context))


@construct(
    "normal",
    signature="[identifier] pattern [amount] modifiers",
    doc="Bumps painted on a surface by turning its normal; the amount says how deep they look.",
    accepts=ACCEPTS,
)
def normal(reader: ItemReader, context: Context, sink: Sink) -> Unread:
    return Unread("normal", reader, lambda items: read_normal(items, context, default_normal(context)))


@construct(
    "normal_map",
    signature="[F normal items] [F normal items] ...",
    doc="Normals for the values 0 to 1 of a pattern; weights under `average`.",
    accepts=ACCEPTS,
)
def normal_map(reader: ItemReader, context: Context, sink: Sink) -> NormalMap:
    named = reader.node(NormalMap)
    if named is not None:
        return named
    base = default_normal(context)
    return NormalMap(read_entries(reader, lambda inner: read_normal_body(inner, context, base)))
