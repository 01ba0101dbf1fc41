"""SDL: ``text { ttf "timrom.ttf" "Hello" 0.1, 0 }``."""

from __future__ import annotations

from typing import Final

from minipov.interpreter.constructs.files import EXTENSIONS, find
from minipov.interpreter.constructs.shape import shape
from minipov.interpreter.context import Context
from minipov.interpreter.errors import SdlError
from minipov.interpreter.reader import ItemReader
from minipov.tracer.objects import Shape
from minipov.tracer.shapes import Text

INTERNAL_FONTS: Final = ("povlogo", "timrom", "cyrvetic", "crystal")


@shape(
    "text",
    signature='ttf "font file" "words" thickness, offset | internal I "words" thickness, offset',
    doc="Words as solid letters, along x, extruded along z.",
    accepts=("ttf", "internal"),
)
def text(reader: ItemReader, context: Context) -> Shape:
    place = reader.place
    word = reader.word("ttf", "internal")
    if word is None:
        reader.fail("'ttf' or 'internal'")
    if word == "ttf":
        path = find(reader, context, "ttf")
    else:
        number = reader.integer()
        name = INTERNAL_FONTS[number if 0 <= number < len(INTERNAL_FONTS) else 0]
        found = context.find_file(name, EXTENSIONS["ttf"])
        if found is None:
            raise SdlError(f"text: the font {name}.ttf is not in the library paths", place)
        path = found
    words = reader.string()
    thickness, offset = reader.float(), reader.vector()
    try:
        return Text(path.read_bytes(), words, thickness, offset)
    except OSError as error:
        raise SdlError(f"text: cannot read '{path}': {error}", place) from error
