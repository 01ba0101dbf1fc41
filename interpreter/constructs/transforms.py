"""SDL: ``translate <1,2,3>  rotate 30*y  scale 2  matrix <12 numbers>  transform { T rotate x inverse }``."""

from __future__ import annotations

from typing import Final

from minipov.interpreter.constructs.common import long_vector, unexpected
from minipov.interpreter.context import Context
from minipov.interpreter.items import Sink, Word
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.transform import IDENTITY, Matrix, Transform

TRANSFORM_WORDS: Final = ("translate", "rotate", "scale", "matrix", "transform")


def read_transform(reader: ItemReader, context: Context) -> Transform | None:
    """One transformation, or None where the next item is none."""
    item = reader.peek()
    if isinstance(item, Transform):
        reader.take()
        return item
    if not isinstance(item, Word):
        return None
    place = reader.place
    match reader.word_of(TRANSFORM_WORDS):
        case "translate":
            return Transform.translate(reader.vector())
        case "rotate":
            return Transform.rotate(reader.vector())
        case "scale":
            x, y, z = reader.vector()
            if 0.0 in (x, y, z):
                context.messages.warn("scale by 0 in one direction: taken as 1", place)
            return Transform.scale((x or 1.0, y or 1.0, z or 1.0))
        case "matrix":
            return _matrix(reader, context)
        case "transform":
            named = reader.node(Transform)
            if named is None:
                reader.fail("a transform identifier or a block after 'transform'")
            return named
    return None


def read_transforms(reader: ItemReader, context: Context) -> Transform:
    """Transformations to the end of the block, multiplied out."""
    total = IDENTITY
    while not reader.at_end:
        transform = read_transform(reader, context)
        if transform is None:
            unexpected(reader, TRANSFORM_WORDS)
        total = total.then(transform)
    return total


def _matrix(reader: ItemReader, context: Context) -> Transform:
    place = reader.place
    numbers = list(long_vector(reader, 12, "a matrix"))
    for column in range(3):
        if numbers[column] == numbers[column + 3] == numbers[column + 6] == 0.0:
            context.messages.warn("matrix flattens space: 1 put on its diagonal", place)
            numbers[4 * column] = 1.0
    matrix: Matrix = tuple(numbers)  # type: ignore[assignment]  # twelve, as asked for
    return Transform(matrix)


@construct(
    "transform",
    signature="[identifier] transformations [inverse]",
    doc="Several transformations in one, to be declared and used again. `inverse` turns the whole of them round.",
    accepts=(*TRANSFORM_WORDS, "inverse"),
)
def transform(reader: ItemReader, context: Context, sink: Sink) -> Transform:
    total, inverted = IDENTITY, False
    while not reader.at_end:
        part = read_transform(reader, context)
        if part is not None:
            total = total.then(part)
        elif reader.word("inverse"):
            inverted = True
        else:
            unexpected(reader, (*TRANSFORM_WORDS, "inverse"))
    if not inverted:
        return total
    try:
        return total.inverse()
    except ZeroDivisionError:
        context.messages.warn("transform flattens space and has no inverse: left out", sink.place)
        return IDENTITY
