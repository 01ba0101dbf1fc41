"""SDL: ``#declare X = `` whose value only the running program knows: it takes the next complete value.

``#declare O = #if (M) merge { #else union { #end ... }``, or textures of which some come from macros.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from minipov.interpreter.arrays import UNSET, Array
from minipov.interpreter.colors import COLOR_WORDS
from minipov.interpreter.errors import Place, SdlError
from minipov.interpreter.items import COMMA, SEMICOLON, Item, Sink, Unread, Word
from minipov.interpreter.runtime.blocks import Blocks
from minipov.interpreter.runtime.rvalues import TEXTURES, rvalue
from minipov.interpreter.values import Vector, kind_of


class DeclarationSink(Sink):
    """Waits for one complete value, then gives it to ``take`` and steps aside."""

    __slots__ = ("blocks", "take")

    def __init__(self, blocks: Blocks, take: Callable[[Any], None], place: Place) -> None:
        super().__init__("declare", place, blocks.sink)
        self.blocks = blocks
        self.take = take

    def extend(self, items: Sequence[Item], places: Sequence[Place]) -> None:
        """Take items one by one; what comes after the value goes to the sink around."""
        for item, place in zip(items, places, strict=True):
            self.blocks.sink.push(item, place)

    def push(self, item: Item, place: Place) -> None:
        """Take an item that may be part of the value."""
        if item is SEMICOLON:
            self.finish()
        elif self._belongs(item):
            super().push(item, place)
            if not self._may_go_on(item):
                self.finish()
        else:
            self.finish()
            self.blocks.sink.push(item, place)

    def _belongs(self, item: Item) -> bool:
        """Whether ``item`` can be part of the value that has begun."""
        if not self.items:
            return True
        if isinstance(self.items[0], Word) and self.items[0].name in COLOR_WORDS:
            word = isinstance(item, Word) and item.name in COLOR_WORDS
            return word or (isinstance(self.items[-1], Word) and isinstance(item, float | Vector))
        return _is_texture(item) or (isinstance(item, Word) and item.name == "texture")

    def _may_go_on(self, item: Item) -> bool:
        return isinstance(item, Word) or isinstance(self.items[0], Word) or _is_texture(item)

    def opening(self, name: str) -> None:
        """A block that is no further layer: the value is complete."""
        if self.items and name != "texture" and not isinstance(self.items[-1], Word):
            self.finish()

    def finish(self) -> None:
        """The value is complete."""
        assert self.parent is not None
        self.blocks.sink = self.parent
        following = []
        while self.items and isinstance(self.items[-1], Word):
            following.append((self.items.pop(), self.places.pop()))
        self.take(rvalue(self.items, self.places, "declaration", self.place))
        for item, place in following:
            self.parent.push(item, place)


class TupleSink(Sink):
    """3.8: the values of ``#declare (A, B) = (1, 2);``, up to the semicolon."""

    __slots__ = ("blocks", "count", "take")

    def __init__(self, blocks: Blocks, take: Callable[[Any], None], place: Place, count: int) -> None:
        super().__init__("declare", place, blocks.sink)
        self.blocks = blocks
        self.take = take
        self.count = count

    def push(self, item: Item, place: Place) -> None:
        """Take an item."""
        if item is not SEMICOLON:
            super().push(item, place)
            return
        assert self.parent is not None
        self.blocks.sink = self.parent
        values = [value for value in self.items if value is not COMMA]
        self.take(values[0] if len(values) == 1 else values)

    def extend(self, items: Sequence[Item], places: Sequence[Place]) -> None:
        """Take items one by one."""
        for item, place in zip(items, places, strict=True):
            self.blocks.sink.push(item, place)


def _is_texture(item: Item) -> bool:
    return isinstance(item, TEXTURES) or (isinstance(item, Unread) and item.name == "texture")


def settle(blocks: Blocks) -> None:
    """A directive that needs all names: a texture still waiting for layers is complete."""
    sink = blocks.sink
    if isinstance(sink, DeclarationSink) and sink.items:
        sink.finish()


def part(value: Any, number: int, optional: bool) -> Any:
    """3.8: one of the values given to several names."""
    parts = value.elements if isinstance(value, Array) else value
    if not isinstance(parts, list | tuple):
        raise SdlError(f"expected several values, found {kind_of(value)}")
    if number < len(parts) and parts[number] is not UNSET:
        return parts[number]
    if optional:
        return UNSET
    raise SdlError(f"there is no value for name {number + 1}")
