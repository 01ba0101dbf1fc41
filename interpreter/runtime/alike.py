"""Statements alike in a row: each shape is a Python function, called with the numbers of each statement.

Where that is possible, the first statement becomes a mould for the others (see `moulds`). The places in a shape's code
are those of its first statement; messages are moved to the one that runs.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Final

from minipov.interpreter.errors import NOWHERE, Messages, Place
from minipov.interpreter.runtime.blocks import Blocks
from minipov.interpreter.runtime.faults import explained
from minipov.interpreter.runtime.moulds import Hole, Mould, Unfit, proofs
from minipov.interpreter.runtime.places import MARK
from numpy.typing import NDArray

Shape = Callable[..., None]
Rows = tuple[Sequence[int], Sequence[int], Sequence[Any]]
"""For each statement its shape and its line; for each shape an array of numbers, one row for each statement."""

_LEAST: Final = 8
"""A mould is made for so many statements."""


class Alike:
    """Runs statements alike."""

    def __init__(self, blocks: Blocks, messages: Messages) -> None:
        self._blocks = blocks
        self._messages = messages

    def run(self, shapes: tuple[Shape, ...], calls: tuple[bool, ...], rows: Rows) -> None:
        """Run the statements in their order; ``calls`` tells the shapes that are macro calls."""
        order, lines, numbers = rows
        first = {shape: line for shape, line in zip(reversed(order), reversed(lines), strict=True)}
        shape = line = 0

        def moved(place: Place) -> Place:
            code, file = shapes[shape].__code__, shapes[shape].__globals__[MARK]
            if place[0] != file or all(own != place[1] for _, _, own in code.co_lines()):
                return place
            return (file, place[1] + line - first[shape], place[2])

        self._messages.moved = moved
        try:
            ways = []
            for shape, array in enumerate(numbers):
                line = first[shape]
                ways.append(self._way(shapes[shape], array, line, may_mould=not calls[shape]))
            for shape, line in zip(order, lines, strict=True):
                ways[shape](line)
        except Exception as raised:
            error = explained(raised, {})
            error.place = moved(error.place)
            raise error from None
        finally:
            self._messages.moved = None

    def _way(self, shape: Shape, array: NDArray[Any], line: int, *, may_mould: bool) -> Callable[[int], None]:
        """What makes the statement of the next row, on the line that it is told."""
        rows = array.tolist()
        mould = self._mould(shape, array, line) if may_mould and len(rows) >= _LEAST else None
        if mould is None:
            numbers = iter(rows)
            return lambda _: shape(*next(numbers))
        place = (shape.__globals__[MARK], line, 1)
        cast, push = mould.cast, self._blocks.push
        fitting = iter(zip(rows, mould.fitting(array).tolist(), strict=True))

        def make(line: int) -> None:
            row, fits = next(fitting)
            if fits:
                push(cast(row, line), place)
            else:
                shape(*row)

        return make

    def _mould(self, shape: Shape, array: NDArray[Any], line: int) -> Mould | None:
        """The mould of a shape, if one can be made and proves right."""
        conditions: list[Any] = []
        first = [Hole(value, index, conditions) for index, value in enumerate(array[0].tolist())]
        try:
            with self._messages.aside() as aside:
                mould = Mould(self._made(shape, first), shape.__globals__[MARK], line, conditions)
                fitting = mould.fitting(array)
                for row in proofs(array):
                    numbers = array[row].tolist()
                    if fitting[row] and mould.cast(numbers, line) != self._made(shape, numbers):
                        return None
        except Exception:  # whatever is wrong with a statement comes up again when it is read in the usual way
            return None
        return mould if fitting[0] and not aside.all else None

    def _made(self, shape: Shape, numbers: Sequence[float]) -> Any:
        """The one item that a statement makes."""
        sink = self._blocks.collect(self._blocks.sink.name, NOWHERE)
        try:
            shape(*numbers)
        finally:
            self._blocks.sink = sink.parent or self._blocks.file
        if len(sink.items) != 1:
            raise Unfit
        return sink.items[0]
