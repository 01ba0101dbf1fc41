"""SDL: ``#declare``, ``#local``, ``#undef``: names and what they stand for.

Scoping is dynamic: a macro sees its callers' locals, then the globals. Every name of a running scene is one `Symbol`,
which points at the `Cell` that the name means *now*. A macro that makes a local points the symbol at a new cell and,
when it ends, back at the old one; so reading a name is ``symbol.c.v`` wherever the program is. A parameter passed by
reference is the caller's own cell under another name.
"""

from __future__ import annotations

from difflib import get_close_matches
from typing import Any

from minipov.grammar.keywords import KEYWORDS
from minipov.interpreter.arrays import Array
from minipov.interpreter.context import current_context
from minipov.interpreter.errors import NotDeclaredError, SdlError
from minipov.interpreter.runtime.places import current_place
from minipov.interpreter.values import kind_of
from minipov.tracer.function import Function


class Cell:
    """A place that holds a value. ``outer`` is what the name meant before, where this is a local."""

    __slots__ = ("outer", "v")

    def __init__(self, value: Any, outer: Any = None) -> None:
        self.v = value
        self.outer = outer


class FixedCell:
    """Holds a function, macro or file: not to be declared anew without ``#undef`` (macros: without ``#macro``)."""

    __slots__ = ("name", "outer", "value")

    def __init__(self, name: str, value: Any, outer: Any = None) -> None:
        self.name = name
        self.value = value
        self.outer = outer

    @property
    def v(self) -> Any:
        """The function, macro or file."""
        return self.value

    @v.setter
    def v(self, value: Any) -> None:
        kind = "a function" if isinstance(self.value, Function) else kind_of(self.value)
        raise SdlError(f"'{self.name}' is {kind} and cannot be declared anew", hint="use #undef first")


class DeprecatedCell:
    """A value that warns when it is read: ``#declare deprecated once "use B instead" A = ...``."""

    __slots__ = ("once", "outer", "text", "value", "warned")

    def __init__(self, value: Any, text: str, once: bool, outer: Any) -> None:
        self.value = value
        self.text = text
        self.once = once
        self.warned = False
        self.outer = outer

    @property
    def v(self) -> Any:
        """The value, after the warning."""
        if not (self.once and self.warned):
            self.warned = True
            current_context().messages.warn(self.text, current_place())
        return self.value

    @v.setter
    def v(self, value: Any) -> None:
        self.value = value


class ElementCell:
    """An element of an array passed by reference."""

    __slots__ = ("array", "indices")
    outer = None

    def __init__(self, array: Array, indices: tuple[float, ...]) -> None:
        self.array = array
        self.indices = indices

    @property
    def v(self) -> Any:
        """The element."""
        return self.array.fetch(*self.indices)

    @v.setter
    def v(self, value: Any) -> None:
        self.array.assign(value, *self.indices)


class Undeclared:
    """What a name means that stands for nothing: reading it is an error, assigning to it makes a global."""

    __slots__ = ("symbol",)
    outer = None

    def __init__(self, symbol: Symbol) -> None:
        self.symbol = symbol

    @property
    def v(self) -> Any:
        """Nothing.

        Raises:
            SdlError: always.
        """
        raise NotDeclaredError(self.symbol.name, self.symbol.names.hint(self.symbol.name))

    @v.setter
    def v(self, value: Any) -> None:
        self.symbol.c = Cell(value)


class Symbol:
    """A name. ``c`` is the cell that it means now."""

    __slots__ = ("c", "name", "names", "undeclared")

    def __init__(self, name: str, names: Names) -> None:
        self.name = name
        self.names = names
        self.undeclared = Undeclared(self)
        self.c: Any = self.undeclared

    def ref(self) -> Any:
        """The cell, to pass by reference."""
        return self.c if self.c is not self.undeclared else self.c.v

    @property
    def declared(self) -> bool:
        """Whether the name stands for something."""
        return self.c is not self.undeclared

    def fix(self, value: Any) -> None:
        """Declare a function, macro or file."""
        if isinstance(self.c, FixedCell):
            self.c.v = value
        self.c = FixedCell(self.name, value, self.c.outer)

    def deprecate(self, value: Any, text: str, once: bool) -> None:
        """Declare something that warns when it is used."""
        self.c = DeprecatedCell(value, text, once, self.c.outer)

    def undefine(self) -> None:
        """Forget the innermost meaning."""
        if not self.declared:
            current_context().messages.warn(f"'{self.name}' is not declared, nothing to undefine", current_place())
        self.c = self.c.outer or self.undeclared


def global_cell(symbol: Symbol, cell: Any) -> Any:
    """3.8: the outermost meaning of a name; ``cell`` is where to begin, None for what the name means now."""
    cell = symbol.c if cell is None else cell
    while cell.outer is not None and cell.outer is not symbol.undeclared:
        cell = cell.outer
    return cell


class Names(dict[str, Symbol]):
    """All names of a running scene, by their text."""

    def __missing__(self, name: str) -> Symbol:
        symbol = self[name] = Symbol(name, self)
        return symbol

    def hint(self, name: str) -> str | None:
        """What was probably meant by a name that stands for nothing."""
        if name in KEYWORDS:
            return f"'{name}' is a word of version {KEYWORDS[name].since}, which #version can ask for"
        known = [text for text, symbol in self.items() if symbol.declared]
        close = get_close_matches(name, [*known, *KEYWORDS], 1, 0.7)
        return f"did you mean '{close[0]}'?" if close else None
