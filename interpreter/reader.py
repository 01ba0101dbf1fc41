"""Reading the items of a closed block: what a construct (``sphere``, ``pigment``, ``camera``) is written with."""

from __future__ import annotations

from collections.abc import Container, Sequence
from typing import Any, Final, NoReturn, TypeAlias, TypeVar

from minipov.interpreter.colors import COLOR_WORDS, read_color
from minipov.interpreter.context import current_context
from minipov.interpreter.errors import Place, SdlError
from minipov.interpreter.items import COMMA, Block, Item, Punctuation, Unread, Word
from minipov.interpreter.values import Vector, kind_of, widened
from minipov.tracer.values import Rgb, Rgbft, Vec2, Vec3, Vec4

T = TypeVar("T")
Terms: TypeAlias = tuple[float, ...]

LARGEST_INTEGER: Final = 2**31 - 1


class ItemReader:
    """A cursor over a block's items. ``name`` is the block's; ``end_place`` that of its closing brace."""

    __slots__ = ("_at", "_end", "_end_place", "_items", "_places", "name")

    def __init__(
        self, name: str, items: Sequence[Item], places: Sequence[Place], end_place: Place, start: int = 0
    ) -> None:
        self.name = name
        self._items = items
        self._places = places
        self._end_place = end_place
        self._at = start
        self._end = len(items)

    def again(self) -> ItemReader:
        """A reader of the same items from where this one stands."""
        return ItemReader(self.name, self._items, self._places, self._end_place, self._at)

    # --- looking ---

    @property
    def at_end(self) -> bool:
        """Whether every item has been read."""
        return self._at >= self._end

    @property
    def place(self) -> Place:
        """Where the next item stands."""
        return self._end_place if self.at_end else self._places[self._at]

    def peek(self) -> Item:
        """The next item, or None at the end."""
        return self._items[self._at] if self._at < self._end else None

    def next_is(self, *words: str) -> bool:
        """Whether the next item is one of these keywords."""
        return self.next_is_of(words)

    def next_is_of(self, words: Container[str]) -> bool:
        """Whether the next item is a keyword of this table."""
        item = self._items[self._at] if self._at < self._end else None
        return item.__class__ is Word and item.name in words

    # --- taking ---

    def take(self) -> Item:
        """The next item, whatever it is."""
        if self.at_end:
            self.fail("something more")
        item = self._items[self._at]
        self._at += 1
        return item

    def comma(self) -> None:
        """Pass over an optional comma."""
        if self._at < self._end and self._items[self._at] is COMMA:
            self._at += 1

    def word(self, *words: str) -> str | None:
        """The next item if it is one of these keywords (any keyword, if none are given), else None."""
        item = self._items[self._at] if self._at < self._end else None
        if item.__class__ is Word and (not words or item.name in words):
            self._at += 1
            name: str = item.name
            return name
        return None

    def word_of(self, words: Container[str]) -> str | None:
        """The next item if it is a keyword of this table, else None."""
        item = self._items[self._at] if self._at < self._end else None
        if item.__class__ is Word and item.name in words:
            self._at += 1
            name: str = item.name
            return name
        return None

    def node(self, kind: type[T] | tuple[type[T], ...]) -> T | None:
        """The next item if it is a value of this type, else None."""
        item = self._items[self._at] if self._at < self._end else None
        if isinstance(item, kind):
            self._at += 1
            return item
        return None

    def block(self, name: str) -> Any:
        """The value of the next item if it is a `Block` of this name, else None."""
        item = self.peek()
        if isinstance(item, Block) and item.name == name:
            self._at += 1
            return item.value
        return None

    def fail(self, expected: str, hint: str | None = None) -> NoReturn:
        """Stop with 'expected ..., found ...' at the next item."""
        raise SdlError(f"{self.name}: expected {expected}, found {describe(self.peek())}", self.place, hint)

    def refuse(self, needed: str, hint: str | None = None) -> NoReturn:
        """Stop with 'needs ...' at the item read last: it was understood, but is not allowed."""
        place = self._places[self._at - 1] if self._at else self.place
        raise SdlError(f"{self.name}: needs {needed}", place, hint)

    # --- numbers, vectors, colours ---

    def terms(self, what: str, most: int) -> Terms:
        """A float (one term) or vector of at most ``most`` terms, with an optional comma before it."""
        items, at = self._items, self._at
        item = items[at] if at < self._end else None
        if item is COMMA:
            self._at = at = at + 1
            item = items[at] if at < self._end else None
        if item.__class__ is Vector and len(item) <= most:
            self._at = at + 1
            return item[:]  # a tuple, in which no operators are left
        if isinstance(item, float):
            self._at = at + 1
            return (item,)
        self.fail(what)

    def rows(self, most: int, size: int) -> list[Terms]:
        """The vectors of ``size`` terms that follow each other, ``most`` at most, with optional commas before them."""
        items, at = self._items, self._at
        rows: list[Terms] = []
        while at < self._end and len(rows) < most:
            item = items[at]
            if item is COMMA and at + 1 < self._end:
                at += 1
                item = items[at]
            if item.__class__ is not Vector or len(item) != size:
                break
            rows.append(item)
            at += 1
            self._at = at
        return rows

    def is_number(self) -> bool:
        """Whether the next item (after an optional comma) is a float or vector."""
        at = self._at + (self.peek() is COMMA)
        return at < len(self._items) and isinstance(self._items[at], float | Vector)

    def is_float(self) -> bool:
        """Whether the next item (after an optional comma) is a float."""
        at = self._at + (self.peek() is COMMA)
        return at < len(self._items) and isinstance(self._items[at], float)

    def next_is_comma(self) -> bool:
        """Whether the next item is a comma."""
        return self.peek() is COMMA

    def float(self) -> float:
        """A float."""
        item = self._items[self._at] if self._at < self._end else None
        if item.__class__ is float:
            self._at += 1
            return item
        return self.terms("a number", 1)[0]

    def integer(self) -> int:
        """A float, cut to an integer towards zero; one beyond 32 bits becomes the last that has so many, and
        what is no number the least."""
        return int(min(max(-LARGEST_INTEGER, self.float()), LARGEST_INTEGER))

    def count(self, most: int = LARGEST_INTEGER, least: int = 0) -> int:
        """An integer that says how many; what is beyond the limits is taken as the limit, with a warning."""
        value = self.integer()
        taken = min(max(value, least), most)
        if value != taken:
            text = f"{self.name}: {value} is beyond {least} to {most}, taken as {taken}"
            current_context().messages.warn(text, self._places[self._at - 1])
        return taken

    def boolean(self) -> bool:
        """An optional float; missing means on."""
        return self.float() != 0.0 if self.is_number() and self.peek() is not COMMA else True

    def vector2(self) -> Vec2:
        """Two terms; a float is copied."""
        a, b = widened(self.terms("a 2-dimensional vector", 2), 2)
        return (a, b)

    def vector(self) -> Vec3:
        """Three terms; a float is copied, a shorter vector padded with zeros."""
        terms = self.terms("a vector", 3)
        a, b, c = terms if len(terms) == 3 else widened(terms, 3)
        return (a, b, c)

    def vector4(self) -> Vec4:
        """Four terms."""
        a, b, c, d = widened(self.terms("a 4-dimensional vector", 4), 4)
        return (a, b, c, d)

    def string(self) -> str:
        """A string, after an optional comma."""
        self.comma()
        text = self.node(str)
        if text is None:
            self.fail("a string")
        return text

    def is_color(self) -> bool:
        """Whether a colour expression starts here (not counting bare floats and vectors)."""
        item = self.peek()
        if item.__class__ is Word:
            return item.name in COLOR_WORDS
        return item.__class__ is Vector and len(item) == 5

    def color(self) -> Rgbft:
        """A colour: ``[color] rgb V``, a value, and any of ``red F`` ... ``transmit F`` after it."""
        return read_color(self)

    def rgb(self) -> Rgb:
        """A colour of which only red, green and blue count."""
        r, g, b, _, _ = self.color()
        return (r, g, b)


def describe(item: Item) -> str:
    """An item in the words of an error message."""
    if item is None:
        return "the closing brace"
    if isinstance(item, Word):
        return f"'{item.name}'"
    if isinstance(item, Punctuation):
        return f"'{item.text}'"
    if isinstance(item, Block):
        return f"a block '{item.name}'"
    if isinstance(item, Unread):
        return f"a {item.name}"
    if isinstance(item, float):
        return f"the number {item:g}"
    return kind_of(item)
