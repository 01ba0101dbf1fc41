"""SDL: ``#macro M(A, B) ... #end``: macros as callable values.

A macro compiled to a Python function takes the cells of its arguments and ``open``, which asks for open terms (see
`splice`). Most macros push items into the open block; one that only works out an expression ``returns`` it instead.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any, Final, NoReturn

from minipov.interpreter.errors import NOWHERE, Place, SdlError
from minipov.interpreter.items import Item
from minipov.interpreter.runtime.blocks import Blocks
from minipov.interpreter.runtime.names import Cell, Symbol
from minipov.interpreter.runtime.places import current_place
from minipov.interpreter.runtime.splice import Spliced, items_of

MISSING: Final = object()
"""Stands where an argument is left out."""


@dataclass(frozen=True, slots=True)
class Gathered:
    """What a macro pushed, as yet unread."""

    items: list[Item]
    places: list[Place]


class Macro:
    """A macro. ``value(*cells)`` gives what stands in an expression; ``run(*cells)`` pushes its items;
    ``single(*cells)`` gives what `calls.rvalue_of` makes one value of.
    """

    __slots__ = (
        "arity",
        "blocks",
        "function",
        "least",
        "name",
        "parameters",
        "returns",
        "run",
        "single",
        "span",
        "symbols",
        "value",
    )
    sdl_kind = "macro"

    def __init__(
        self,
        name: str,
        parameters: tuple[str, ...],
        symbols: tuple[Symbol, ...],
        blocks: Blocks,
        least: int,
        function: Callable[..., Any],
        returns: bool,
        span: tuple[int, int],
    ) -> None:
        self.name = name
        self.parameters = parameters
        self.symbols = symbols
        self.arity = len(parameters)
        self.least = least
        self.function = function
        self.returns = returns
        self.span = span
        self.blocks = blocks
        self.value: Callable[..., Any] = function if returns else self._captured
        self.single: Callable[..., Any] = partial(function, open=False) if returns else self._gathered
        self.run: Callable[..., None] = self._pushed if returns else partial(function, open=False)

    def _captured(self, *cells: Any) -> Any:
        blocks = self.blocks
        sink = blocks.collect("(", ("", 0, 0))
        self.function(*cells)
        blocks.collected(sink)
        items = sink.items
        if len(items) == 1 and isinstance(items[0], _VALUES):
            return items[0]
        return Spliced(items)

    def _gathered(self, *cells: Any) -> Gathered:
        return Gathered(*self.items(*cells))

    def _pushed(self, *cells: Any) -> None:
        place = current_place()
        for item in items_of(self.function(*cells, open=False)):
            self.blocks.push(item, place)

    def items(self, *cells: Any) -> tuple[list[Item], list[Any]]:
        """The items of a call, and their places."""
        if self.returns:
            found = items_of(self.function(*cells, open=False))
            return found, [NOWHERE] * len(found)
        sink = self.blocks.collect("argument", ("", 0, 0))
        self.run(*cells)
        self.blocks.collected(sink)
        return sink.items, sink.places

    def filled(self, cells: list[Any]) -> list[Any]:
        """The cells of all parameters: those of optional ones (3.8) that are left out stand for nothing.

        Raises:
            SdlError: there are too many or too few arguments.
        """
        given = cells[:-1] if len(cells) > self.arity and cells[-1] is MISSING else cells
        given = given + [MISSING] * (self.arity - len(given))
        if len(given) > self.arity or any(cell is MISSING for cell in given[: self.least]):
            self._refuse(len(given) if len(given) > self.arity else len(cells))
        return [
            symbol.undeclared if cell is MISSING else cell for cell, symbol in zip(given, self.symbols, strict=True)
        ]

    def _refuse(self, found: int) -> NoReturn:
        wanted = f"{self.arity} argument{'s' * (self.arity != 1)}"
        raise SdlError(
            f"macro '{self.name}' takes {wanted}, found {found}",
            hint=f"it is defined as {self.name}({', '.join(self.parameters)})",
        )


_VALUES = (float, tuple, str)


def spread(arguments: list[Any]) -> list[Any]:
    """Argument cells of a call in which a macro may have given several arguments."""
    cells: list[Any] = []
    for argument in arguments:
        cells += [Cell(item) for item in items_of(argument)]
    return cells
