"""SDL: ``M(A, 2)``, ``F(x.y)``, ``sin(a)``, ``concat(...)``, ``defined(X)``, ``trace(...)``: calls.

Whether ``M`` is a macro is known only when the scene runs. Macros take cells (the caller's own where the argument is a
variable), all else takes values; so a call is compiled for both, and arguments that are not trivial are worked out
once.
"""

from __future__ import annotations

import ast
from collections.abc import Sequence
from typing import Final

from minipov.grammar import tree
from minipov.interpreter.compiler.expressions import Expressions
from minipov.interpreter.compiler.shapes import EXPRESSIONS, argument_groups, constant, may_splice, never_color
from minipov.interpreter.errors import SdlError
from minipov.interpreter.runtime.builtins import BUILTINS

_TESTS: Final = frozenset({"defined"})
_NAMED: Final = frozenset({"trace"})


class Calls(Expressions):
    """Compiles calls."""

    def call(self, node: tree.Call) -> ast.expr:
        """A call as an operand."""
        return self._call(node, "value")

    def run_call(self, node: tree.Call) -> None:
        """A call as an item: a macro pushes what it makes, a function's value is pushed."""
        called = self._call(node, "run")
        self.add(self.emit.at(node).do(called))

    def items_call(self, node: tree.Call) -> ast.expr:
        """A call whose items are wanted: ``(items, places)``."""
        return self._call(node, "items")

    def _call(self, node: tree.Call, way: str) -> ast.expr:
        groups = argument_groups(node.items)
        callee = self.value(node.of)
        self.emit.at(node)
        if groups is None:
            sink = self.emit.name(self.gather(node.items, "call", node))
            return self.emit.at(node).call("call_gathered", callee, self.emit.constant(way), sink, self.place(node))
        first: list[ast.expr] = []
        arguments = [self._argument(group, first, node) for group in groups]
        self.emit.at(node)
        if not all(groups):
            cells = self.emit.list([cell for cell, _ in arguments])
            return self.emit.call("call_with", cells, callee, self.emit.constant(way))
        if any(len(group) == 1 and may_splice(group[0]) and not isinstance(group[0], tree.Call) for group in groups):
            cells = self.emit.list([cell for cell, _ in arguments])
            return self.emit.call("call_spread", callee, self.emit.constant(way), *first, cells)
        called = self.unit.unique("m")
        test = self._is_macro(self.emit.named(called, callee), called, len(arguments), first)
        macro = self.emit.call(self.emit.attribute(self.emit.name(called), way), *[cell for cell, _ in arguments])
        other = self.emit.call("call", self.emit.name(called), *[value for _, value in arguments])
        if way == "run":
            other = self.emit.call("push_all", other, self.place(node))
        elif way == "items":
            other = self.emit.tuple([self.emit.list([other]), self.emit.list([self.place(node)])])
        return self.emit.conditional(test, macro, other)

    def _is_macro(self, callee: ast.expr, called: str, count: int, first: list[ast.expr]) -> ast.expr:
        """Whether the callee is a macro of so many arguments; works out the callee and ``first`` on the way."""
        if first:
            callee = self.emit.item(self.emit.tuple([*first, callee]), len(first))
        is_macro = self.emit.compare(self.emit.attribute(callee, "__class__"), ast.Is(), self.emit.name("Macro"))
        arity = self.emit.attribute(self.emit.name(called), "arity")
        return self.emit.both(is_macro, self.emit.compare(arity, ast.Eq(), self.emit.constant(count)))

    def _argument(
        self, group: Sequence[tree.Item], first: list[ast.expr], node: tree.Node
    ) -> tuple[ast.expr, ast.expr]:
        """An argument as a cell and as a value; what must be worked out once goes into ``first``."""
        if not group:
            missing = self.emit.at(node).name("MISSING")
            return missing, missing
        item = group[0]
        if len(group) == 1 and isinstance(item, tree.Name):
            value = self.expression(item)
            return self.emit.call(self.emit.attribute(self.symbol(item.name), "ref")), value
        if len(group) == 1 and isinstance(item, tree.Subscript):
            container, indices = self.element(item)
            element = self.unit.unique("t")
            first.append(self.emit.named(element, self.emit.call("element", container, self.emit.tuple(indices))))
            return self.emit.name(element), self.emit.attribute(self.emit.name(element), "v")
        if len(group) == 1 and constant(item) is not None:
            value = self.expression(item)  # type: ignore[arg-type]  # constants are expressions
            return self.emit.call("Cell", value), value
        argument = self.unit.unique("t")
        first.append(self.emit.named(argument, self.rvalue(group, "argument")))
        return self.emit.call("Cell", self.emit.name(argument)), self.emit.name(argument)

    def rvalue(self, group: Sequence[tree.Item], what: str) -> ast.expr:
        """The one value that a group of items (as `argument_groups` makes them) is."""
        item = group[0]
        if len(group) == 1 and isinstance(item, tree.Call):
            called = self._call(item, "single")
            self.emit.at(item)
            return self._unless_float(called, "rvalue_of", self.emit.constant(what), self.place(item))
        if len(group) == 1 and isinstance(item, tree.Keyword) and item.name not in ("array", "dictionary"):
            return self.emit.at(item).name(self.unit.constants.add(("word", item.name)))
        if len(group) == 1 and isinstance(item, EXPRESSIONS):
            value = self.expression(item)
            if isinstance(item, tree.Name | tree.Subscript):
                return self._unless_float(value, "copied")
            if may_splice(item) and what != "argument":
                value = self.emit.at(item).call("value_of", value)
            self.emit.at(item)
            return value if never_color(item) else self._unless_float(value, "stored")
        sink = self.gather(group, what, item)
        return self.emit.at(item).call("rvalue_in", self.emit.name(sink), self.place(item))

    def _unless_float(self, value: ast.expr, function: str, *more: ast.expr) -> ast.expr:
        """``function(value, ...)``, spared where the value is a float."""
        name = self.unit.unique("t")
        is_float = self.is_float(self.emit.named(name, value))
        other = self.emit.call(function, self.emit.name(name), *more)
        return self.emit.conditional(is_float, self.emit.name(name), other)

    def builtin_call(self, node: tree.BuiltinCall) -> ast.expr:
        """A call of a function of the language."""
        groups = argument_groups(node.items)
        if node.name in _TESTS and groups is not None and len(groups) == 1 and len(groups[0]) == 1:
            test = self.is_defined(groups[0][0])
            return self.emit.call("float", test)
        builtin = BUILTINS.get(node.name)
        if builtin is None:
            return self._failing(SdlError(f"'{node.name}' cannot be called here"), node)
        name = self.emit.at(node).name(f"f_{node.name}")
        if groups is None or not all(len(group) == 1 and isinstance(group[0], EXPRESSIONS) for group in groups):
            sink = self.emit.name(self.gather(node.items, "call", node))
            return self.emit.at(node).call("builtin_gathered", self.emit.constant(node.name), name, sink)
        parts: list[tree.Expression] = [group[0] for group in groups]  # type: ignore[misc]  # expressions, as just seen
        if not builtin.least <= len(parts) <= builtin.most and any(map(may_splice, parts)):
            tokens = self.tokens(node.items)
            return self.emit.at(node).call("builtin_spread", self.emit.constant(node.name), name, tokens)
        if not builtin.least <= len(parts) <= builtin.most:
            return self._failing(SdlError(count_message(node.name, len(parts))), node)
        values = [self._builtin_argument(node.name, number, part) for number, part in enumerate(parts)]
        return self.emit.at(node).call(self.emit.name(f"f_{node.name}"), *values)

    def _builtin_argument(self, name: str, number: int, part: tree.Expression) -> ast.expr:
        if name in _NAMED and number == 3:
            return self.target(part)
        return self.value(part)

    def target(self, node: tree.Expression) -> ast.expr:
        """A cell to assign to."""
        if isinstance(node, tree.Name):
            return self.cell(node.name)
        if isinstance(node, tree.Subscript):
            container, indices = self.element(node)
            return self.emit.call("element", container, self.emit.tuple(indices))
        return self._failing(SdlError("expected a variable"), node)

    def is_defined(self, node: tree.Item) -> ast.expr:
        """Whether a name or element stands for something, as a Python truth."""
        self.emit.at(node)
        match node:
            case tree.Name(name=name):
                undeclared = self.emit.attribute(self.symbol(name), "undeclared")
                return self.emit.compare(self.cell(name), ast.IsNot(), undeclared)
            case tree.Scoped(name=name):
                undeclared = self.emit.attribute(self.symbol(name), "undeclared")
                return self.emit.compare(self.scoped_cell(node), ast.IsNot(), undeclared)
            case tree.Subscript() | tree.Member():
                of: tree.Expression = node
                indices: list[ast.expr] = []
                while isinstance(of, tree.Subscript | tree.Member):
                    index = self.value(of.index) if isinstance(of, tree.Subscript) else self.emit.constant(of.name)
                    indices.insert(0, index)
                    of = of.of
                if isinstance(of, tree.Name):
                    return self.emit.call("holds", self.symbol(of.name), self.emit.tuple(indices))
            case tree.Paren(inner=inner):
                return self.is_defined(inner)
        return self.emit.constant(False)

    def _failing(self, error: SdlError, node: tree.Node) -> ast.expr:
        """Code that raises ``error`` when it is reached."""
        return self.emit.at(node).call("fail", self.emit.constant(error.message), self.emit.constant(error.hint))


def count_message(name: str, found: int) -> str:
    """What is wrong with a call that has so many arguments."""
    builtin = BUILTINS[name]
    wanted = str(builtin.least) if builtin.least == builtin.most else f"{builtin.least} or more"
    if builtin.least < builtin.most < 10:
        wanted = f"{builtin.least} to {builtin.most}"
    return f"{name}() takes {wanted} argument{'s' * (wanted != '1')}, found {found}"
