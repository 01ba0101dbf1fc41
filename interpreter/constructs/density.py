"""SDL: ``density { spherical color_map { [0 rgb 0] [1 rgb 1] } scale 2 }`` in a ``media``."""

from __future__ import annotations

from typing import Final

from minipov.interpreter.constructs.common import unexpected
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
from minipov.interpreter.constructs.pigment import DEFAULT_BLOCK_COLORS
from minipov.interpreter.context import Context
from minipov.interpreter.items import Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.interior import Density, DensityList, DensityMap
from minipov.tracer.node import replace
from minipov.tracer.pattern import Pattern
from minipov.tracer.pigment import ColorMap

MAPS: Final[tuple[type[ColorMap | DensityMap], ...]] = (ColorMap, DensityMap)
ACCEPTS: Final = (
    *PATTERN_WORDS,
    *PATTERN_MODIFIERS,
    *PARAMETERS,
    *("rgb", "color", "color_map", "colour_map", "density_map"),
)


def read_density_body(reader: ItemReader, context: Context) -> Density:
    """A density, up to the first item that belongs to none."""
    density = _read_kind(reader, context, read_named(reader, Density, Density()))
    while not reader.at_end:
        modifiers = read_pattern_modifier(reader, context, density.modifiers)
        if modifiers is not None:
            density = replace(density, modifiers=modifiers)
            continue
        blend = reader.node(MAPS)
        if blend is not None:
            density = replace(density, blend=blend)
            continue
        pattern = read_pattern_parameter(reader, density.pattern)
        if pattern is None:
            break
        density = replace(density, pattern=pattern)
    return density


def _read_kind(reader: ItemReader, context: Context, base: Density) -> Density:
    """The colour or pattern that must come first."""
    if reader.is_color():
        return replace(base, color=reader.rgb(), pattern=None, blend=None)
    by_object = object_pattern(reader, context)
    if by_object is not None:
        return replace(base, pattern=by_object[0], blend=_block_list(by_object[1], by_object[0]))
    pattern = read_pattern(reader, context)
    if pattern is None:
        return base
    return replace(base, pattern=pattern, blend=_block_list(reader, pattern))


def _block_list(reader: ItemReader, pattern: Pattern) -> DensityList | None:
    given = block_items(reader, block_count(pattern), lambda: _block_item(reader))
    if not given:
        return None
    rest = DEFAULT_BLOCK_COLORS[pattern_word(pattern)][len(given) :]
    return DensityList((*given, *map(Density, rest)))


def _block_item(reader: ItemReader) -> Density | None:
    if reader.is_color() or reader.is_number():
        return Density(reader.rgb())
    return reader.node(Density)


@construct(
    "density",
    signature="[identifier] color | pattern, then modifiers",
    doc="How thick a media is from point to point; several densities multiply.",
    accepts=ACCEPTS,
)
def density(reader: ItemReader, context: Context, sink: Sink) -> Density:
    result = read_density_body(reader, context)
    if not reader.at_end:
        unexpected(reader, ACCEPTS)
    return result


@construct(
    "density_map",
    signature="[F density items] [F density items] ...",
    doc="Densities for the values 0 to 1 of a pattern; weights under `average`.",
    accepts=ACCEPTS,
)
def density_map(reader: ItemReader, context: Context, sink: Sink) -> DensityMap:
    named = reader.node(DensityMap)
    if named is not None:
        return named
    return DensityMap(read_entries(reader, lambda inner: read_density_body(inner, context)))
