"""SDL: ``pigment { bozo color_map { [0 rgb 0] [1 rgb 1] } scale 2 }``."""

from __future__ import annotations

from typing import Final

from minipov.interpreter.constructs.common import unexpected, unread
from minipov.interpreter.constructs.maps import read_blend, read_entries
from minipov.interpreter.constructs.pattern_modifiers import (
    PARAMETERS,
    PATTERN_MODIFIERS,
    read_named,
    read_pattern_modifier,
    read_pattern_parameter,
)
from minipov.interpreter.constructs.patterns import (
    FUNCTION_TYPES,
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
from minipov.tracer.function import Function
from minipov.tracer.node import replace
from minipov.tracer.pattern import ImageMap, Pattern, PigmentPattern
from minipov.tracer.pigment import ColorMap, Pigment, PigmentList, PigmentMap, UserDefinedPigment
from minipov.tracer.texture import PlainTexture

MAPS: Final[tuple[type[ColorMap | PigmentMap], ...]] = (ColorMap, PigmentMap)
ACCEPTS: Final = (
    *PATTERN_WORDS,
    *PATTERN_MODIFIERS,
    *PARAMETERS,
    *("color", "rgb", "rgbf", "rgbt", "rgbft", "srgb", "color_map", "colour_map", "pigment_map"),
    *("quick_color", "quick_colour", "user_defined"),
)

_BLUE, _GREEN, _RED = (0.0, 0.0, 1.0), (0.0, 1.0, 0.0), (1.0, 0.0, 0.0)
_YELLOW, _CYAN, _MAGENTA = (1.0, 1.0, 0.0), (0.0, 1.0, 1.0), (1.0, 0.0, 1.0)
DEFAULT_BLOCK_COLORS: Final = {
    "brick": ((0.5, 0.5, 0.5), (0.6, 0.15, 0.15)),
    "checker": (_BLUE, _GREEN),
    "object": (_BLUE, _GREEN),
    "hexagon": (_BLUE, _GREEN, _RED),
    "square": (_RED, _GREEN, _BLUE, _YELLOW),
    "cubic": (_RED, _GREEN, _BLUE, _YELLOW, _CYAN, _MAGENTA),
    "triangular": (_RED, _GREEN, _BLUE, _YELLOW, _CYAN, _MAGENTA),
}


def default_pigment(context: Context) -> Pigment:
    """The pigment of the default texture: what every pigment block starts from."""
    default = context.default_texture
    return default.pigment if isinstance(default, PlainTexture) else Pigment()


def read_pigment(reader: ItemReader, context: Context, base: Pigment) -> Pigment:
    """``base`` with what a pigment block says."""
    pigment = read_pigment_body(reader, context, base)
    if not reader.at_end:
        unexpected(reader, ACCEPTS)
    return pigment


def read_pigment_body(reader: ItemReader, context: Context, base: Pigment) -> Pigment:
    """As `read_pigment`, up to the first item that belongs to no pigment."""
    pigment = _read_kind(reader, context, read_named(reader, Pigment, base))
    while not reader.at_end:
        changed = _modified(reader, context, pigment)
        if changed is None:
            break
        pigment = changed
    if pigment.pattern is not None and pigment.blend is None and pattern_word(pigment.pattern) == "average":
        reader.refuse("a pigment_map for 'average'")
    return pigment


def _read_kind(reader: ItemReader, context: Context, base: Pigment) -> Pigment:
    """The colour, pattern or image that must come first."""
    if reader.is_color():
        return replace(base, color=reader.color(), pattern=None, blend=None)
    user_defined = reader.node(UserDefinedPigment)
    if user_defined is not None:
        return replace(base, pattern=None, blend=user_defined)
    by_object = object_pattern(reader, context)
    if by_object is not None:
        return replace(base, pattern=by_object[0], blend=_block_list(by_object[1], context, by_object[0]))
    pattern = read_pattern(reader, context)
    if pattern is None:
        return base
    if block_count(pattern):
        return replace(base, pattern=pattern, blend=_block_list(reader, context, pattern))
    fitting = isinstance(base.blend, ColorMap | PigmentMap) and not isinstance(pattern, ImageMap)
    return replace(base, pattern=pattern, blend=base.blend if fitting else None)


def _modified(reader: ItemReader, context: Context, pigment: Pigment) -> Pigment | None:
    modifiers = read_pattern_modifier(reader, context, pigment.modifiers)
    if modifiers is not None:
        return replace(pigment, modifiers=modifiers)
    blend = reader.node(MAPS)
    if blend is not None:
        return replace(pigment, blend=blend)
    if reader.word("quick_color", "quick_colour"):
        return replace(pigment, quick_color=reader.color())
    pattern = read_pattern_parameter(reader, pigment.pattern)
    if pattern is not None:
        return replace(pigment, pattern=pattern)
    return None


def _block_list(reader: ItemReader, context: Context, pattern: Pattern) -> PigmentList | None:
    """The colours or pigments of a block pattern; colours not given are the pattern's own, pigments the default one."""
    by_color = _is_color(reader)
    given = block_items(reader, block_count(pattern), lambda: _block_item(reader, context))
    if not given:
        return None
    rest = DEFAULT_BLOCK_COLORS[pattern_word(pattern)][len(given) :]
    others = (Pigment((*rgb, 0.0, 0.0)) if by_color else default_pigment(context) for rgb in rest)
    return PigmentList((*given, *others))


def _is_color(reader: ItemReader) -> bool:
    return reader.is_color() or reader.is_number()


def _block_item(reader: ItemReader, context: Context) -> Pigment | None:
    inner = unread(reader, "pigment")
    if inner is not None:
        return read_pigment(inner, context, default_pigment(context))
    if _is_color(reader):
        return Pigment(reader.color())
    return reader.node(Pigment)


@construct(
    "pigment",
    signature="[identifier] color | pattern | image_map, then modifiers",
    doc="The colour of every point. Colour, pattern or image come first; modifiers and transformations follow.",
    accepts=ACCEPTS,
)
def pigment(reader: ItemReader, context: Context, sink: Sink) -> Unread:
    return Unread("pigment", reader, lambda items: read_pigment(items, context, default_pigment(context)))


@construct(
    "pigment_map",
    signature="[F pigment items] [F pigment items] ...",
    doc="Pigments for the values 0 to 1 of a pattern, mixed between the entries; weights under `average`.",
    accepts=ACCEPTS,
)
def pigment_map(reader: ItemReader, context: Context, sink: Sink) -> PigmentMap:
    named = reader.node(PigmentMap)
    if named is not None:
        return named
    said = read_blend(reader)
    base = default_pigment(context)
    return PigmentMap(read_entries(reader, lambda inner: read_pigment_body(inner, context, base)), **said)


@construct(
    "pigment_pattern",
    signature="like pigment",
    doc="The grey value of a pigment as a pattern.",
    accepts=ACCEPTS,
)
def pigment_pattern(reader: ItemReader, context: Context, sink: Sink) -> PigmentPattern:
    return PigmentPattern(read_pigment(reader, context, default_pigment(context)))


@construct(
    "user_defined",
    within=("pigment",),
    signature="function {} function {} function {} [function {} function {}]",
    doc="Functions of x, y, z for red, green, blue, filter and transmit (3.8).",
    accepts=("function",),
)
def user_defined(reader: ItemReader, context: Context, sink: Sink) -> UserDefinedPigment:
    functions: list[Function | None] = []
    while not reader.at_end:
        reader.comma()
        function = reader.node(FUNCTION_TYPES)
        if function is None:
            reader.fail("a function")
        functions.append(function)
    if not functions:
        reader.fail("a function")
    return UserDefinedPigment(tuple(functions + [None] * (5 - len(functions))))
