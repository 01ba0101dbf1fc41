"""SDL: ``color_map { [0 rgb 0] [1 rgb 1] }``, and what all maps share: a list of ``[F body]``."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final, TypeVar

from minipov.interpreter.constructs.common import Field, expect_end, integer, number, read_fields, unexpected
from minipov.interpreter.context import Context
from minipov.interpreter.items import Entry, Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.interpreter.values import Vector
from minipov.tracer.normal import SlopeMap
from minipov.tracer.pigment import ColorMap
from minipov.tracer.values import Rgbft

T = TypeVar("T")

BLEND_FIELDS: Final[dict[str, Field]] = {"blend_mode": integer("blend_mode"), "blend_gamma": number("blend_gamma")}


def read_entries(reader: ItemReader, body: Callable[[ItemReader], T]) -> tuple[tuple[float, T], ...]:
    """The entries ``[F body]`` to the end of the block; a missing number (a weight, under ``average``) is 1."""
    entries = []
    while not reader.at_end:
        inner = next_entry(reader)
        value = inner.float() if inner.is_float() else 1.0
        inner.comma()
        entries.append((value, body(inner)))
        expect_end(inner)
    if not entries:
        reader.fail("at least one entry [ number ... ]")
    return tuple(entries)


def next_entry(reader: ItemReader) -> ItemReader:
    """The reader of the next entry's items."""
    place = reader.place
    entry = reader.node(Entry)
    if entry is None:
        reader.comma()
        entry = reader.node(Entry)
    if entry is None:
        reader.fail("an entry in brackets: [ number ... ]")
    return ItemReader(f"{reader.name} entry", entry.items, entry.places, entry.places[-1] if entry.places else place)


def read_blend(reader: ItemReader) -> dict[str, Any]:
    """3.8: ``blend_mode I blend_gamma F`` before the first entry."""
    said: dict[str, Any] = {}
    while (fields := read_fields(reader, BLEND_FIELDS)) is not None:
        said.update(fields)
    return said


@construct(
    "color_map",
    "colour_map",
    signature="[F color] [F color] ...",
    doc="Colours for the values 0 to 1 of a pattern, mixed linearly between the entries.",
    accepts=tuple(BLEND_FIELDS),
)
def color_map(reader: ItemReader, context: Context, sink: Sink) -> ColorMap:
    named = reader.node(ColorMap)
    if named is not None:
        expect_end(reader)
        return named
    said = read_blend(reader)
    entries: list[tuple[float, Rgbft]] = []
    while not reader.at_end:
        inner = next_entry(reader)
        start = inner.float()
        if _is_old_style(inner):
            end = inner.float()
            entries.append((start, inner.color()))
            inner.comma()
            entries.append((end, inner.color()))
        else:
            inner.comma()
            entries.append((start, inner.color()))
        expect_end(inner)
    if not entries:
        unexpected(reader, BLEND_FIELDS)
    return ColorMap(tuple(entries), **said)


def _is_old_style(reader: ItemReader) -> bool:
    """Whether a second number follows the first, as in ``[0.0, 0.5 color A color B]``."""
    if not reader.is_number():
        return False
    reader.comma()
    return not isinstance(reader.peek(), Vector)


@construct(
    "slope_map",
    signature="[F <height, slope>] ...",
    doc="Heights and slopes for the values of a pattern: the profile of a bump.",
)
def slope_map(reader: ItemReader, context: Context, sink: Sink) -> SlopeMap:
    named = reader.node(SlopeMap)
    if named is not None:
        expect_end(reader)
        return named
    return SlopeMap(read_entries(reader, ItemReader.vector2))
