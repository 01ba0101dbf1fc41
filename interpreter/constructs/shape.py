"""SDL: what all objects have in common: ``sphere { PARAMETERS modifiers }`` or ``sphere { IDENTIFIER modifiers }``."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, TypeAlias

from minipov.interpreter.constructs.modifiers import MODIFIERS, read_modifiers
from minipov.interpreter.context import Context
from minipov.interpreter.items import Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.objects import Object, Shape, Union

ShapeReader: TypeAlias = Callable[[ItemReader, Context], Shape]

NOTHING: Final = Union(())
"""The shape of a degenerate object: it is not there."""


def source_of(sink: Sink) -> str:
    """Where an object was made, for the messages of the renderer."""
    file, line, _ = sink.place
    return f"{file}:{line}"


def shape(
    name: str, *, signature: str, doc: str, accepts: tuple[str, ...] = ()
) -> Callable[[ShapeReader], ShapeReader]:
    """Enter an object into the table of constructs; ``read`` reads its parameters, modifiers may follow."""

    def register(read: ShapeReader) -> ShapeReader:
        @construct(name, signature=f"{signature} [modifiers]", doc=doc, accepts=(*accepts, *MODIFIERS))
        def read_object(reader: ItemReader, context: Context, sink: Sink) -> Object:
            thing = reader.node(Object) or Object(read(reader, context), source=source_of(sink))
            return read_modifiers(reader, context, thing)

        return read

    return register
