"""What the readers of all constructs share: tables of ``word value`` items, and the error for an item out of place."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from difflib import get_close_matches
from typing import Any, NoReturn, TypeAlias

import numpy as np
from minipov.interpreter import registry
from minipov.interpreter.items import Unread, Word
from minipov.interpreter.reader import LARGEST_INTEGER, ItemReader
from minipov.interpreter.values import Vector
from numpy.typing import NDArray

Field: TypeAlias = Callable[[ItemReader], dict[str, Any]]
"""Reads what follows a keyword; gives the fields of the node that it sets."""


def number(field: str) -> Field:
    """``word F``."""
    return lambda reader: {field: reader.float()}


def integer(field: str) -> Field:
    """``word I``."""
    return lambda reader: {field: reader.integer()}


def count(field: str, most: int = LARGEST_INTEGER, least: int = 0) -> Field:
    """``word I`` that says how many, within limits."""
    return lambda reader: {field: reader.count(most, least)}


def boolean(field: str) -> Field:
    """``word [B]``: missing means on."""
    return lambda reader: {field: reader.boolean()}


def switch(field: str) -> Field:
    """``word``, which takes no boolean."""
    return lambda reader: {field: True}


def required_boolean(field: str) -> Field:
    """``word B``."""
    return lambda reader: {field: reader.float() != 0.0}


def vector(field: str) -> Field:
    """``word V``."""
    return lambda reader: {field: reader.vector()}


def rgb(field: str) -> Field:
    """``word C``, of which red, green and blue count."""
    return lambda reader: {field: reader.rgb()}


def color(field: str) -> Field:
    """``word C``."""
    return lambda reader: {field: reader.color()}


def text(field: str) -> Field:
    """``word S``."""
    return lambda reader: {field: reader.string()}


def one_or_two_integers(field: str, second: Callable[[int], int]) -> Field:
    """``word I[, I]``, which say how many; ``second`` gives the second from the first where it is missing."""

    def read(reader: ItemReader) -> dict[str, Any]:
        first = reader.count()
        return {field: (first, reader.count() if reader.is_number() else second(first))}

    return read


def read_fields(reader: ItemReader, table: Mapping[str, Field]) -> dict[str, Any] | None:
    """The fields that the next keyword sets, or None where the next item is no keyword of ``table``."""
    word = reader.word_of(table)
    return None if word is None else table[word](reader)


def read_all_fields(reader: ItemReader, table: Mapping[str, Field]) -> dict[str, Any]:
    """A block that holds nothing but ``word value`` items."""
    fields: dict[str, Any] = {}
    while not reader.at_end:
        read = read_fields(reader, table)
        if read is None:
            unexpected(reader, table)
        fields.update(read)
    return fields


def unread(reader: ItemReader, name: str) -> ItemReader | None:
    """The reader of the next item if it is an unread block of this name, else None."""
    item = reader.peek()
    if isinstance(item, Unread) and item.name == name:
        reader.take()
        return item.reader.again()
    return None


def expect_end(reader: ItemReader, accepts: Iterable[str] = ()) -> None:
    """Fail where items are left over."""
    if not reader.at_end:
        unexpected(reader, accepts)


def unexpected(reader: ItemReader, accepts: Iterable[str]) -> NoReturn:
    """Stop at an item that may not stand here; say what may, and where the item would be right."""
    words = sorted(set(accepts))
    item = reader.peek()
    hint = None
    if isinstance(item, Word):
        close = [] if item.name in words else get_close_matches(item.name, words, 1)
        homes = sorted({c.name for c in registry.constructs() if item.name in c.accepts} - {reader.name})
        if item.name in words:
            hint = f"'{item.name}' may stand in {reader.name}, but not after what comes before it"
        elif close:
            hint = f"did you mean '{close[0]}'?"
        elif item.name in words:
            hint = f"'{item.name}' must come earlier, or once only"
        elif homes:
            hint = f"'{item.name}' may stand in {', '.join(homes[:4])}"
    if hint is None and words:
        hint = f"{reader.name} accepts: {', '.join(words)}"
    reader.fail("another item or the closing brace" if words else "the closing brace", hint)


def long_vector(reader: ItemReader, size: int, what: str) -> tuple[float, ...]:
    """``<F, F, ...>`` with exactly ``size`` numbers."""
    reader.comma()
    item = reader.peek()
    numbers: tuple[float, ...] = ()
    if isinstance(item, np.ndarray):
        numbers = tuple(float(value) for value in item.ravel())
    elif isinstance(item, Vector):
        numbers = tuple(item)
    if len(numbers) != size:
        reader.fail(f"{what} ({size} numbers)", f"there are {len(numbers)}" if numbers else None)
    reader.take()
    return numbers


def bulk(reader: ItemReader, rows: int, columns: int, what: str) -> NDArray[np.float64]:
    """``rows`` vectors of ``columns`` numbers, with optional commas; runs of literals come as arrays."""
    parts: list[NDArray[np.float64]] = []
    singles: list[tuple[float, ...]] = []
    have = 0
    while have < rows:
        found = reader.rows(rows - have, columns)
        if found:
            singles += found
            have += len(found)
            continue
        reader.comma()
        item = reader.peek()
        if isinstance(item, np.ndarray):
            block = item.reshape(-1, item.shape[-1])
            if block.shape[1] > columns:
                reader.fail(what)
            if have + len(block) > rows:
                reader.fail(f"{rows} of {what}", f"there are at least {have + len(block)}")
            if singles:
                parts.append(np.array(singles))
                singles = []
            padded = np.zeros((len(block), columns))
            padded[:, : block.shape[1]] = block
            parts.append(padded)
            have += len(block)
            reader.take()
        else:
            terms = reader.terms(what, columns)
            singles.append(terms * columns if len(terms) == 1 else tuple(terms) + (0.0,) * (columns - len(terms)))
            have += 1
    if singles:
        parts.append(np.array(singles))
    return np.concatenate(parts) if parts else np.zeros((0, columns))
