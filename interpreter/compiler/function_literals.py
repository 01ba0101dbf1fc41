"""SDL: ``function (x, y) { sin(x)*y + F(x, 0, 0) }``: code that builds a function's tree (`minipov.tracer.function`).

Names are looked up when the function is declared: floats are kept as constants, functions as calls. A body with
directives, or one in which a macro is called, is read by `runtime.function_text` instead.
"""

from __future__ import annotations

import ast
from collections.abc import Sequence
from typing import Final

from minipov.grammar import tree
from minipov.interpreter.compiler.calls import Calls
from minipov.interpreter.compiler.shapes import EXPRESSIONS, argument_groups
from minipov.interpreter.errors import SdlError
from minipov.interpreter.functions import DEFAULT_PARAMETERS, FLOAT_FUNCTIONS, component_number, parameter_numbers

_DEEPEST: Final = 100


class FunctionLiterals(Calls):
    """Compiles functions."""

    def function_literal(self, node: tree.FunctionLiteral) -> ast.expr:
        """``function { ... }``, as code that gives a node of `minipov.tracer.function`."""
        if isinstance(node.body, tree.FunctionBlock):
            function = self._block_function(node.body)
        else:
            function = self._expression_function(node, node.body)
        if node.size is None:
            return function
        width, height = map(self.value, node.size)
        return self.emit.at(node).call("sized_function", width, height, function)

    def _expression_function(self, node: tree.FunctionLiteral, body: tree.Expression | tree.FunctionText) -> ast.expr:
        source = node.source
        assert source is not None
        parameters = self.emit.at(node).constant(node.parameters)
        text = self.emit.call("function_of_text", parameters, self.emit.constant(source.text), self.place(source))
        called = None if isinstance(body, tree.FunctionText) else _called(body)
        if called is None or isinstance(body, tree.FunctionText):
            return text
        code = self._body(body, parameter_numbers(node.parameters))
        parameters = self.emit.at(node).constant(node.parameters or DEFAULT_PARAMETERS)
        function = self.emit.call("ExpressionFunction", parameters, code)
        if not called:
            return function
        symbols = [self.symbol(name) for name in sorted(called)]
        return self.emit.conditional(self.emit.call("any_macro", *symbols), text, function)

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
                component = component_number(name)
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
        codes = [self._body(argument, scope) for argument in arguments]
        callee = self.expression(of)
        self.emit.at(node)
        return self.emit.call("function_call", callee, self.emit.tuple(codes), self.emit.constant(component))

    def _expressions(self, items: Sequence[tree.Item]) -> list[tree.Expression] | None:
        groups = argument_groups(items)
        if groups is None or not all(len(group) == 1 and isinstance(group[0], EXPRESSIONS) for group in groups):
            return None
        return [group[0] for group in groups]  # type: ignore[misc]  # expressions, as just seen

    def _refused(self, message: str, node: tree.Node) -> ast.expr:
        return self._failing(SdlError(message), node)


def _called(body: tree.Expression) -> set[str] | None:
    """The names called in a body; None if it is nested so deeply that Python's compiler might not take it."""
    called: set[str] = set()
    level: list[tree.Item] = [body]
    for _ in range(_DEEPEST):
        inner: list[tree.Item] = []
        for item in level:
            match item:
                case tree.Binary(operator=operator, left=left, right=right):
                    while isinstance(left, tree.Binary) and left.operator == operator:
                        inner.append(left.right)
                        left = left.left
                    inner += (left, right)
                case tree.Unary(operand=operand) | tree.Paren(inner=operand) | tree.Member(of=operand):
                    inner.append(operand)
                case tree.Call(of=of, items=items):
                    while isinstance(of, tree.Subscript):
                        of = of.of
                    if isinstance(of, tree.Name):
                        called.add(of.name)
                    inner += items
                case tree.BuiltinCall(items=items):
                    inner += items
        if not inner:
            return called
        level = inner
    return None
