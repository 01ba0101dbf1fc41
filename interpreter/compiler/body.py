"""The Python function that is being written: its statements, temporary names, and the symbols it reads."""

from __future__ import annotations

import ast
from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from minipov.grammar import tree
from minipov.interpreter.compiler.constants import Constants
from minipov.interpreter.compiler.emit import Emitter
from minipov.interpreter.errors import Place


class Unit:
    """One file's compiled parts: symbols and constants it refers to, and the functions of its macros."""

    def __init__(self, path: str, *, utf8: bool = True) -> None:
        self.path = path
        self.utf8 = utf8
        self.symbols: set[str] = set()
        self.constants = Constants()
        self.functions: list[ast.stmt] = []
        self._count = 0

    def unique(self, prefix: str) -> str:
        """A name used nowhere else in the file."""
        self._count += 1
        return f"{prefix}{self._count}"


class Body(ABC):
    """A function in the making. Expressions that need statements before them add these to ``statements``."""

    is_file = True
    """Whether this is a file's own code, not a macro's."""

    gathering = False
    """Whether what is pushed are parts of one expression: ``(1 #if (A) + 2 #end)``."""

    opens = False
    """Whether what is pushed here may be open terms, as the function's variable ``open`` says."""

    def __init__(self, unit: Unit, parameters: Sequence[str] = (), local_names: Iterable[str] = ()) -> None:
        self.unit = unit
        self.emit = Emitter()
        self.parameters = tuple(parameters)
        self.local_names = frozenset(local_names)
        self.statements: list[ast.stmt] = []

    @abstractmethod
    def items(self, items: Sequence[tree.Item]) -> None:
        """Statements that push items."""

    @abstractmethod
    def expression(self, node: tree.Expression) -> ast.expr:
        """The value of an expression; where `may_splice` says so, perhaps a `Spliced`."""

    @contextmanager
    def block(self) -> Iterator[list[ast.stmt]]:
        """Statements made inside go into a list of their own."""
        outer, self.statements = self.statements, []
        try:
            yield self.statements
        finally:
            self.statements = outer

    @contextmanager
    def inside(self, *, gathering: bool) -> Iterator[None]:
        """Items inside brackets, which are no part of what the function leaves."""
        outer = self.gathering, self.opens
        self.gathering, self.opens = gathering, False
        try:
            yield
        finally:
            self.gathering, self.opens = outer

    def add(self, statement: ast.stmt) -> None:
        """One more statement."""
        self.statements.append(statement)

    def do(self, function: str, *arguments: ast.expr) -> None:
        """A call for its effect."""
        self.add(self.emit.do(self.emit.call(function, *arguments)))

    def kept(self, value: ast.expr, prefix: str = "t") -> str:
        """A variable that holds ``value``."""
        name = self.unit.unique(prefix)
        self.add(self.emit.assign(name, value))
        return name

    def symbol(self, name: str) -> ast.expr:
        """The `Symbol` of an SDL name."""
        self.unit.symbols.add(name)
        return self.emit.name(f"s_{name}")

    def cell(self, name: str) -> ast.expr:
        """The cell that an SDL name means now."""
        return self.emit.attribute(self.symbol(name), "c")

    def place(self, node: tree.Node) -> ast.expr:
        """A node's place as a constant."""
        return self.emit.constant(self.at(node))

    def at(self, node: tree.Node) -> Place:
        """A node's place."""
        return (self.unit.path, node.line, node.column)

    def plain(self, value: Any) -> ast.expr:
        """A constant, kept in the file's table unless a code object can hold it."""
        if isinstance(value, tuple):
            return self.emit.name(self.unit.constants.add(("vector", tuple(value))))
        return self.emit.constant(value)
