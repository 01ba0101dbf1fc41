"""Items: what a running scene pushes, one after the other, into the block that is open.

SDL is read block by block. ``sphere { <0,0,0>, 1 pigment { rgb x } }`` opens a sink named ``sphere``, into which come a
vector, a comma, a float, and what the block ``pigment`` gave. When a block closes, the construct of its name reads
its items (`reader.ItemReader`) and yields one value, pushed into the sink above.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Final, TypeAlias

from minipov.interpreter.errors import NOWHERE, Place
from minipov.tracer.node import node

if TYPE_CHECKING:
    from minipov.interpreter.reader import ItemReader
    from minipov.tracer.function import Function


@dataclass(frozen=True, slots=True)
class Word:
    """A keyword that stands as an item by itself (``open``, ``color``, ``area_light``)."""

    name: str


@dataclass(frozen=True, slots=True)
class Punctuation:
    """``,`` or ``;`` between items."""

    text: str


@dataclass(frozen=True, slots=True)
class Named:
    """A name among the tokens of a function's body: a parameter, or what it stands for, None for nothing."""

    name: str
    value: Any


COMMA: Final = Punctuation(",")
SEMICOLON: Final = Punctuation(";")


@node
class Block:
    """A block whose value needs its name to be understood (``interior_texture {...}``, ``vertex_vectors {...}``).

    Blocks that yield a scene node of one type (``pigment {...}`` a `Pigment`) push the node itself, without this.
    """

    name: str
    value: Any


@node
class Unread:
    """A block whose meaning depends on what it stands in, not read yet: ``finish {...}`` changes the finish of the
    texture or object around it. A declaration, an array element or a macro argument takes ``complete(item)`` instead.
    """

    name: str
    reader: ItemReader
    alone: Callable[[ItemReader], Any]


def complete(item: Item) -> Item:
    """The item as a value by itself: an `Unread` block is read on top of the current defaults."""
    return item.alone(item.reader.again()) if isinstance(item, Unread) else item


@dataclass(frozen=True, slots=True)
class Entry:
    """A bracket ``[ ... ]``: an entry of a map. Its items are kept, for the map to read."""

    items: tuple[Item, ...]
    places: tuple[Place, ...]


@dataclass(frozen=True, slots=True)
class FunctionImage:
    """``function W, H { ... }``: a function to be sampled on the unit square, in place of an image file."""

    width: int
    height: int
    function: Function


Item: TypeAlias = Any
"""A `Word`, `Punctuation`, `Block`, `Unread`, `Entry`, NumPy array (a bulk run of literals), or a value of SDL: float,
`Vector`, str, `Array`, function, spline, map, `Transform`, or any node of the scene graph."""


@dataclass(slots=True)
class Sink:
    """An open block and its items so far.

    ``name`` is the word before the brace, "" for none, "file" at top level, "[" in a bracket, "#default" in that
    directive's block.
    """

    name: str
    place: Place = NOWHERE
    parent: Sink | None = None
    items: list[Item] = field(default_factory=list)
    places: list[Place] = field(default_factory=list)

    def push(self, item: Item, place: Place) -> None:
        """Add one item."""
        self.items.append(item)
        self.places.append(place)

    def extend(self, items: Sequence[Item], places: Sequence[Place]) -> None:
        """Add several items."""
        self.items.extend(items)
        self.places.extend(places)

    def opening(self, name: str) -> None:
        """A block ``name`` is about to open in this sink."""

    def within(self, *names: str) -> bool:
        """Whether one of the blocks around this one has one of these names."""
        sink = self.parent
        while sink is not None:
            if sink.name in names:
                return True
            sink = sink.parent
        return False
