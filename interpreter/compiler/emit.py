"""Small pieces of Python ``ast``, each at the place of an SDL node."""

from __future__ import annotations

import ast
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

if TYPE_CHECKING:
    from minipov.grammar import tree

Statements: TypeAlias = list[ast.stmt]
Names: TypeAlias = list[str]


class Emitter:
    """Makes ``ast`` nodes at the place of the SDL node last named by `at`."""

    __slots__ = ("_place", "column", "line")

    def __init__(self) -> None:
        self.line, self.column = 1, 1
        self._place: dict[str, Any] = {}
        self.move(1, 1)

    def at(self, node: tree.Node) -> Emitter:
        """From here on, at this node."""
        self.move(node.line, node.column)
        return self

    def move(self, line: int, column: int) -> None:
        """From here on, at this place."""
        self.line, self.column = line, column
        self._place = {"lineno": line, "end_lineno": line, "col_offset": column - 1, "end_col_offset": column}

    # --- expressions ---

    def constant(self, value: Any) -> ast.expr:
        """A literal that code objects can hold."""
        return ast.Constant(value, **self._place)

    def name(self, text: str) -> ast.expr:
        """A variable's value."""
        return ast.Name(text, ast.Load(), **self._place)

    def attribute(self, of: ast.expr, name: str) -> ast.expr:
        """``of.name``."""
        return ast.Attribute(of, name, ast.Load(), **self._place)

    def call(self, function: str | ast.expr, *arguments: ast.expr) -> ast.expr:
        """``function(arguments)``."""
        callee = self.name(function) if isinstance(function, str) else function
        return ast.Call(callee, list(arguments), [], **self._place)

    def tuple(self, elements: Sequence[ast.expr]) -> ast.expr:
        """``(elements,)``."""
        return ast.Tuple(list(elements), ast.Load(), **self._place)

    def list(self, elements: Sequence[ast.expr]) -> ast.expr:
        """``[elements]``."""
        return ast.List(list(elements), ast.Load(), **self._place)

    def binary(self, left: ast.expr, operator: ast.operator, right: ast.expr) -> ast.expr:
        """``left operator right``."""
        return ast.BinOp(left, operator, right, **self._place)

    def unary(self, operator: ast.unaryop, operand: ast.expr) -> ast.expr:
        """``operator operand``."""
        return ast.UnaryOp(operator, operand, **self._place)

    def compare(self, left: ast.expr, operator: ast.cmpop, *right: ast.expr) -> ast.expr:
        """``left operator right``; with more than one ``right``, ``left operator right operator right ...``."""
        return ast.Compare(left, [operator] * len(right), list(right), **self._place)

    def both(self, *values: ast.expr) -> ast.expr:
        """``a and b``."""
        return ast.BoolOp(ast.And(), list(values), **self._place)

    def either(self, *values: ast.expr) -> ast.expr:
        """``a or b``."""
        return ast.BoolOp(ast.Or(), list(values), **self._place)

    def conditional(self, test: ast.expr, yes: ast.expr, no: ast.expr) -> ast.expr:
        """``yes if test else no``."""
        return ast.IfExp(test, yes, no, **self._place)

    def named(self, name: str, value: ast.expr) -> ast.expr:
        """``(name := value)``."""
        return ast.NamedExpr(ast.Name(name, ast.Store(), **self._place), value, **self._place)

    def starred(self, elements: ast.expr) -> ast.expr:
        """``*elements``."""
        return ast.Starred(elements, ast.Load(), **self._place)

    def item(self, of: ast.expr, index: int) -> ast.expr:
        """``of[index]``."""
        return ast.Subscript(of, self.constant(index), ast.Load(), **self._place)

    # --- statements ---

    def do(self, expression: ast.expr) -> ast.stmt:
        """An expression for its effect."""
        return ast.Expr(expression, **self._place)

    def assign(self, name: str, value: ast.expr) -> ast.stmt:
        """``name = value``."""
        return ast.Assign([ast.Name(name, ast.Store(), **self._place)], value, **self._place)

    def set(self, of: ast.expr, attribute: str, value: ast.expr) -> ast.stmt:
        """``of.attribute = value``."""
        return ast.Assign([ast.Attribute(of, attribute, ast.Store(), **self._place)], value, **self._place)

    def if_(self, test: ast.expr, body: Statements, otherwise: Statements) -> ast.stmt:
        """``if test: body else: otherwise``."""
        return ast.If(test, body or [self.nothing()], otherwise, **self._place)

    def while_(self, test: ast.expr, body: Statements) -> ast.stmt:
        """``while test: body``."""
        return ast.While(test, body or [self.nothing()], [], **self._place)

    def try_(self, body: Statements, error: str, handler: Statements) -> ast.stmt:
        """``try: body except Exception as error: handler``."""
        caught = ast.ExceptHandler(self.name("Exception"), error, handler, **self._place)
        return ast.Try(body or [self.nothing()], [caught], [], [], **self._place)

    def break_(self) -> ast.stmt:
        """``break``."""
        return ast.Break(**self._place)

    def nothing(self) -> ast.stmt:
        """``pass``."""
        return ast.Pass(**self._place)

    def nonlocal_(self, names: Names) -> ast.stmt:
        """``nonlocal names``."""
        return ast.Nonlocal(names, **self._place)

    def return_(self, value: ast.expr | None) -> ast.stmt:
        """``return value``."""
        return ast.Return(value, **self._place)

    def function(self, name: str, parameters: Sequence[str], body: Statements, opens: bool) -> ast.stmt:
        """``def name(parameters, open=True): body``."""
        arguments = [ast.arg(parameter, **self._place) for parameter in parameters]
        defaults: list[ast.expr] = []
        if opens:
            arguments.append(ast.arg("open", **self._place))
            defaults.append(self.constant(True))
        signature = ast.arguments([], arguments, None, [], [], None, defaults)
        return ast.FunctionDef(name, signature, body or [self.nothing()], [], **self._place)
