"""The table of constructs: which function reads the items of which block.

>>> @construct("sphere", signature="center, radius", doc="A ball.")
... def sphere(reader: ItemReader, context: Context, sink: Sink) -> Object: ...

A construct that means something else inside another block says so with ``within``: the ``sphere`` of a ``blob``.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

from minipov.interpreter.context import Context
from minipov.interpreter.items import Item, Sink
from minipov.interpreter.reader import ItemReader

Reader: TypeAlias = Callable[[ItemReader, Context, Sink], Item]


@dataclass(frozen=True, slots=True)
class Construct:
    """One construct: its reader, and what people are told about it (errors, completion, hover, docs).

    ``node`` is the class whose fields are named after the block's keywords; their defaults are what holds unsaid.
    """

    name: str
    read: Reader
    signature: str
    doc: str
    within: tuple[str, ...] = ()
    accepts: tuple[str, ...] = ()
    node: type | None = None


_CONSTRUCTS: dict[tuple[str, str], Construct] = {}


def construct(
    *names: str,
    signature: str,
    doc: str,
    within: tuple[str, ...] = (),
    accepts: tuple[str, ...] = (),
    node: type | None = None,
) -> Callable[[Reader], Reader]:
    """Enter a reader into the table under ``names``; ``within`` limits it to blocks directly in those blocks.

    ``accepts`` lists the keywords that may stand in the block (for completion and 'did you mean'), ``node`` tells their
    defaults.
    """

    def register(read: Reader) -> Reader:
        for name in names:
            entry = Construct(name, read, signature, doc, within, accepts, node)
            for parent in within or ("",):
                _CONSTRUCTS[parent, name] = entry
        return read

    return register


def find(name: str, parent: str) -> Construct | None:
    """The construct for a block ``name`` directly inside a block ``parent``."""
    return _CONSTRUCTS.get((parent, name)) or _CONSTRUCTS.get(("", name))


def constructs() -> tuple[Construct, ...]:
    """All of them, for the editor and the documentation."""
    return tuple(_CONSTRUCTS.values())


def names() -> frozenset[str]:
    """The words that begin a block somewhere."""
    return frozenset(name for _, name in _CONSTRUCTS)
