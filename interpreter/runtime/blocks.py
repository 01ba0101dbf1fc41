"""SDL: ``sphere { ... }``: opening and closing blocks while a scene runs, loose braces included.

There is always one sink, into which items are pushed. A block opens a sink of its own; when the block closes, its
construct reads the items and yields one value, which is pushed into the sink around it.
"""

from __future__ import annotations

from collections.abc import Sequence

from minipov.interpreter import constructs  # noqa: F401  # fills the table of constructs
from minipov.interpreter.constructs.top_level import instantiate
from minipov.interpreter.context import Context
from minipov.interpreter.errors import Place, SdlError
from minipov.interpreter.items import SEMICOLON, Entry, Item, Punctuation, Sink, Word
from minipov.interpreter.reader import ItemReader, describe
from minipov.interpreter.registry import find, names


class FileSink(Sink):
    """The top level: complete values join the scene, a word waits for its brace."""

    __slots__ = ("context",)

    def __init__(self, context: Context) -> None:
        super().__init__("file")
        self.context = context

    def push(self, item: Item, place: Place) -> None:
        """Take a value into the scene."""
        if isinstance(item, Word):
            self.settle()
            super().push(item, place)
        elif not isinstance(item, Punctuation):
            self.settle()
            instantiate(item, place, self.context)
        elif item is not SEMICOLON:
            raise SdlError(f"expected an object or a directive, found '{item.text}'", place)

    def extend(self, items: Sequence[Item], places: Sequence[Place]) -> None:
        """Take values into the scene."""
        for item, place in zip(items, places, strict=True):
            self.push(item, place)

    def settle(self) -> None:
        """Complain of a word that no brace followed."""
        if self.items:
            raise SdlError(f"expected an object or a directive, found {describe(self.items[0])}", self.places[0])


class Blocks:
    """The sinks of a running scene. ``sink`` is the innermost."""

    __slots__ = ("context", "file", "sink")

    def __init__(self, context: Context) -> None:
        self.context = context
        self.file = FileSink(context)
        self.sink: Sink = self.file

    def push(self, item: Item, place: Place) -> None:
        """One item into the open block."""
        self.sink.push(item, place)

    def extend(self, items: Sequence[Item], places: Sequence[Place]) -> None:
        """A run of items into the open block."""
        self.sink.extend(items, places)

    def open(self, name: str, place: Place) -> None:
        """``name {``."""
        self.sink.opening(name)
        self.sink = Sink(name, place, self.sink)

    def open_brace(self, place: Place) -> None:
        """``{`` by itself: the block is named by the word pushed before."""
        sink = self.sink
        if sink.items and isinstance(sink.items[-1], Word):
            word = sink.items.pop()
            self.sink = Sink(word.name, sink.places.pop(), sink)
        else:
            self.sink = Sink("", place, sink)

    def close(self, place: Place) -> None:
        """``}``: the construct of the block reads its items."""
        sink = self.sink
        parent = sink.parent
        if parent is None or sink.name in _NO_BRACE:
            raise SdlError("there is no open block for this '}'", place)
        construct = find(sink.name, parent.name)
        if construct is None:
            raise SdlError(*_no_such_block(sink), hint=_hint(sink.name))
        value = construct.read(ItemReader(sink.name, sink.items, sink.places, place), self.context, sink)
        self.sink = parent
        if value is not None:
            parent.push(value, sink.place)

    def open_bracket(self, place: Place) -> None:
        """``[``: an entry of a map."""
        self.sink = Sink("[", place, self.sink)

    def close_bracket(self, place: Place) -> None:
        """``]``."""
        sink = self.sink
        if sink.name != "[" or sink.parent is None:
            raise SdlError("there is no open '[' for this ']'", place)
        self.sink = sink.parent
        self.sink.push(Entry(tuple(sink.items), tuple(sink.places)), sink.place)

    def collect(self, name: str, place: Place) -> Sink:
        """A sink that only gathers items, until `collected`."""
        self.sink = sink = Sink(name, place, self.sink)
        return sink

    def collected(self, sink: Sink) -> None:
        """End the gathering of ``sink``."""
        if self.sink is not sink:
            raise SdlError(f"'}}' is missing for '{self.sink.name}'", self.sink.place)
        assert sink.parent is not None
        self.sink = sink.parent

    def abandon(self) -> None:
        """Forget all that is open: the statement cannot be read."""
        self.file.items.clear()
        self.file.places.clear()
        self.sink = self.file

    def finish(self, place: Place) -> None:
        """The scene ends here: complain of what is still open."""
        if self.sink is not self.file:
            raise SdlError(
                f"'}}' is missing for '{self.sink.name}'", self.sink.place, "the block opened here never ends"
            )
        self.file.settle()


_NO_BRACE = frozenset({"file", "[", "(", "<", "declare", "argument", "call"})


def _no_such_block(sink: Sink) -> tuple[str, Place]:
    if not sink.name:
        return "a block in braces needs a word before it", sink.place
    return f"'{sink.name}' does not begin a block here", sink.place


def _hint(name: str) -> str | None:
    from difflib import get_close_matches

    close = get_close_matches(name, names(), 1)
    return f"did you mean '{close[0]}'?" if close else None
