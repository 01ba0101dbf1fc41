"""SDL: ``function (x, y) { sin(x)*y + F(x, 0, 0) }``: code that builds a function's tree (`minipov.tracer.function`).

Names are looked up when the function is declared: floats are kept as constants, functions as calls.
"""

from __future__ import annotations

import ast
from collections.abc import Sequence
from typing import Final

from minipov.grammar import tree
from minipov.interpreter.compiler.calls import Calls
from minipov.interpreter.compiler.shapes import EXPRESSIONS, argument_groups
from minipov.interpreter.errors import SdlError
from minipov.interpreter.values import COMPONENTS

_DEFAULT_PARAMETERS: Final = ("x", "y", "z")
_ALIASES: Final = {"u": "x", "v": "y"}
_UNARY_FUNCTIONS: Final = (
    "abs", "acos", "acosh", "asin", "asinh", "atan", "atanh", "ceil", "cos", "cosh", "degrees", "exp", "floor", "int",
    "ln", "log", "radians", "sin", "sinh", "sqrt", "tan", "tanh",
)  # fmt: skip
FLOAT_FUNCTIONS: Final = {
    **dict.fromkeys(_UNARY_FUNCTIONS, (1, 1)),
    **dict.fromkeys(("atan2", "mod", "pow"), (2, 2)),
    **dict.fromkeys(("max", "min"), (1, 99)),
    "select": (3, 4),
}
"""The functions that may stand in a function's body, and how many arguments they take."""


class FunctionLiterals(Calls):
    """Compiles functions."""

    def function_literal(self, node: tree.FunctionLiteral) -> ast.expr:
        """``function { ... }``, as code that gives a node of `minipov.tracer.function`."""
        if isinstance(node.body, tree.FunctionBlock):
            function = self._block_function(node.body)
        else:
            parameters = _DEFAULT_PARAMETERS if node.parameters is None else node.parameters
            scope = {name: number for number, name in enumerate(parameters)}
            if node.parameters is None:
                scope |= {alias: scope[name] for alias, name in _ALIASES.items()}
            body = self._body(node.body, scope)
            self.emit.at(node)
            function = self.emit.call("ExpressionFunction", self.emit.constant(tuple(parameters)), body)
        if node.size is None:
            return function
        width, height = map(self.value, node.size)
        return self.emit.at(node).call("sized_function", width, height, function)

    def _block_function(self, block: tree.FunctionBlock) -> ast.expr:
        if block.name == "internal":
            parts = [item for item in block.items if isinstance(item, EXPRESSIONS)]
            number = self.value(parts[0]) if parts else self.emit.constant(-1.0)
            return self.emit.at(block).call("internal_function", number)
        sink = self.emit.at(block).call("collect", self.emit.constant("function"), self.place(block))
        name = self.kept(sink, "sink")
        self.do("open_block", self.emit.constant(block.name), self.place(block))
        self.items(block.items)
        self.emit.at(block)
        self.do("close_block", self.place(block))
        self.do("collected", self.emit.name(name))
        return self.emit.call("block_function", self.emit.name(name))

    def _body(self, node: tree.Expression, scope: dict[str, int]) -> ast.expr:
        """Code that gives the `Expression` of one piece of the body."""
        self.emit.at(node)
        match node:
            case tree.Number(value=number):
                return self.emit.call("Constant", self.emit.constant(number))
            case tree.Paren(inner=inner):
                return self._body(inner, scope)
            case tree.Name(name=name) | tree.ConstantWord(name=name) if name in scope:
                return self.emit.call("Parameter", self.emit.constant(scope[name]))
            case tree.Name() | tree.ConstantWord() | tree.Subscript():
                value = self.expression(node)
                return self.emit.at(node).call("captured", value)
            case tree.Unary(operator=operator, operand=operand) if operator != "!":
                inside = self._body(operand, scope)
                return inside if operator == "+" else self._operation("neg", [inside], node)
            case tree.Binary():
                return self._chain(node, scope)
            case tree.BuiltinCall():
                return self._builtin(node, scope)
            case tree.Call(of=of, items=items):
                return self._function_call(of, items, None, node, scope)
            case tree.Member(of=tree.Call(of=of, items=items), name=name):
                component = -1 if name == "gray" else COMPONENTS.get(name, 9)
                return self._function_call(of, items, component, node, scope)
        return self._refused("this cannot stand in a function", node)

    def _chain(self, node: tree.Binary, scope: dict[str, int]) -> ast.expr:
        """``a + b + c ...``: one operation of all its operands, so that long sums are not nested deeply."""
        operands: list[tree.Expression] = []
        left: tree.Expression = node
        while isinstance(left, tree.Binary) and left.operator == node.operator:
            operands.append(left.right)
            left = left.left
        operands.append(left)
        return self._operation(node.operator, [self._body(operand, scope) for operand in reversed(operands)], node)

    def _operation(self, operator: str, operands: Sequence[ast.expr], node: tree.Node) -> ast.expr:
        self.emit.at(node)
        return self.emit.call("Operation", self.emit.constant(operator), self.emit.tuple(operands))

    def _builtin(self, node: tree.BuiltinCall, scope: dict[str, int]) -> ast.expr:
        arguments = self._expressions(node.items)
        if arguments is None:
            return self._refused(f"{node.name}(): expected expressions between commas", node)
        if node.name in ("sum", "prod"):
            return self._accumulate(node, arguments, scope)
        counts = FLOAT_FUNCTIONS.get(node.name)
        if counts is None:
            return self._refused(f"{node.name}() cannot stand in a function", node)
        if not counts[0] <= len(arguments) <= counts[1]:
            return self._refused(f"{node.name}(): wrong number of arguments ({len(arguments)})", node)
        return self._operation(node.name, [self._body(argument, scope) for argument in arguments], node)

    def _accumulate(self, node: tree.BuiltinCall, arguments: list[tree.Expression], scope: dict[str, int]) -> ast.expr:
        if len(arguments) != 4 or not isinstance(arguments[0], tree.Name | tree.ConstantWord):
            return self._refused(f"{node.name}() is written ({node.name}(name, first, last, expression))", node)
        index = max(scope.values(), default=-1) + 1
        first, last = self._body(arguments[1], scope), self._body(arguments[2], scope)
        body = self._body(arguments[3], {**scope, arguments[0].name: index})
        self.emit.at(node)
        kind, number = self.emit.constant(node.name), self.emit.constant(index)
        return self.emit.call("accumulate", kind, number, first, last, body)

    def _function_call(
        self,
        of: tree.Expression,
        items: Sequence[tree.Item],
        component: int | None,
        node: tree.Node,
        scope: dict[str, int],
    ) -> ast.expr:
        arguments = self._expressions(items)
        if arguments is None:
            return self._refused("expected expressions between commas", node)
        called = self.unit.unique("m")
        callee = self.emit.named(called, self.expression(of))
        codes = [self._body(argument, scope) for argument in arguments]
        cells = [self._macro_argument(argument) for argument in arguments]
        names = None if "v" in scope and scope.get("y") == scope["v"] else tuple(dict.fromkeys(scope))
        self.emit.at(node)
        m = self.emit.name(called)
        is_macro = self.emit.compare(self.emit.attribute(callee, "__class__"), ast.Is(), self.emit.name("Macro"))
        function = self.emit.call("function_call", m, self.emit.tuple(codes), self.emit.constant(component))
        parameters = self.emit.constant(names)
        macro = self.emit.call("macro_in_function", m, self.emit.list(cells), parameters, self.place(node))
        return self.emit.conditional(is_macro, macro, function)

    def _macro_argument(self, argument: tree.Expression) -> ast.expr:
        """An argument as a macro takes it; in a function, no parameters can be among these."""
        if isinstance(argument, tree.Name):
            return self.emit.at(argument).call(self.emit.attribute(self.symbol(argument.name), "ref"))
        return self.emit.at(argument).call("Cell", self.expression(argument))

    def _expressions(self, items: Sequence[tree.Item]) -> list[tree.Expression] | None:
        groups = argument_groups(items)
        if groups is None or not all(len(group) == 1 and isinstance(group[0], EXPRESSIONS) for group in groups):
            return None
        return [group[0] for group in groups]  # type: ignore[misc]  # expressions, as just seen

    def _refused(self, message: str, node: tree.Node) -> ast.expr:
        return self._failing(SdlError(message), node)
