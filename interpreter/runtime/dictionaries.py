"""SDL 3.8: ``dictionary { ["width"]: 3, .height: 4 }``: values by name."""

from __future__ import annotations

from minipov.interpreter.arrays import Dictionary
from minipov.interpreter.context import Context
from minipov.interpreter.items import COMMA, Entry, Item, Punctuation, Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.interpreter.runtime.rvalues import rvalue


@construct(
    "dictionary",
    signature='["name"]: VALUE, .name: VALUE ...',
    doc='Values by name; D["name"] or D.name is one of them.',
)
def dictionary(reader: ItemReader, context: Context, sink: Sink) -> Dictionary:
    """A dictionary of what the entries say."""
    entries = Dictionary()
    while not reader.at_end:
        key = reader.take()
        if not isinstance(key, Entry) or len(key.items) != 1 or reader.take() != Punctuation(":"):
            reader.fail('an entry: ["name"]: VALUE or .name: VALUE')
        place = reader.place
        items: list[Item] = []
        places = []
        while not reader.at_end and reader.peek() is not COMMA:
            places.append(reader.place)
            items.append(reader.take())
        entries.assign(rvalue(items, places, "dictionary", place), key.items[0])
        reader.comma()
    return entries
