"""SDL: ``2*A + <1, 0, B>``, ``(A < B ? x : y)``, ``V.x``, ``Arr[i][j]``: expressions."""

from __future__ import annotations

import ast
from abc import abstractmethod
from collections.abc import Sequence
from typing import Final

from minipov.grammar import tree
from minipov.grammar.lexer import unescape
from minipov.interpreter.compiler.body import Body
from minipov.interpreter.compiler.shapes import EXPRESSIONS, constant, is_comma, may_splice
from minipov.interpreter.values import COMPONENTS, EPSILON

_PYTHON: Final[dict[str, type[ast.operator]]] = {"+": ast.Add, "-": ast.Sub, "*": ast.Mult}
_ORDER: Final[dict[str, type[ast.cmpop]]] = {"<": ast.Lt, ">": ast.Gt}
_HELPERS: Final = {"=": "equal", "!=": "unequal", "<=": "less_equal", ">=": "greater_equal", "&": "both", "|": "either"}
_RELATIONS: Final = frozenset({*_ORDER, "=", "!=", "<=", ">="})


class Expressions(Body):
    """Compiles expressions. Arithmetic becomes Python's; what Python does otherwise goes through `operators`."""

    @abstractmethod
    def call(self, node: tree.Call) -> ast.expr:
        """A call of a macro, function or spline."""

    @abstractmethod
    def builtin_call(self, node: tree.BuiltinCall) -> ast.expr:
        """A call of one of the language's own functions."""

    @abstractmethod
    def function_literal(self, node: tree.FunctionLiteral) -> ast.expr:
        """``function { ... }``."""

    def value(self, node: tree.Expression) -> ast.expr:
        """An expression where exactly one value must stand."""
        value = self.expression(node)
        return self.emit.call("value_of", value) if may_splice(node) else value

    def expression(self, node: tree.Expression) -> ast.expr:
        """The value of an expression."""
        known = constant(node)
        self.emit.at(node)
        if known is not None:
            return self.plain(known)
        match node:
            case tree.Name(name=name):
                return self.emit.attribute(self.cell(name), "v")
            case tree.String(raw=raw):
                return self._characters(raw)
            case tree.Hole(index=index):
                return self.emit.name(f"n{index}")
            case tree.Scoped():
                return self.emit.attribute(self.scoped_cell(node), "v")
            case tree.ConstantWord(name=name):
                return self._variable(name)
            case tree.Paren(inner=inner):
                return self.value(inner)
            case tree.Group():
                return self._group(node)
            case tree.Vector():
                return self._vector(node)
            case tree.Unary():
                return self._unary(node)
            case tree.Binary():
                return self._binary(node)
            case tree.Conditional():
                return self._conditional(node)
            case tree.Member():
                return self._member(node)
            case tree.Subscript():
                return self._subscript(node)
            case tree.Call():
                return self.call(node)
            case tree.BuiltinCall():
                return self.builtin_call(node)
            case tree.FunctionLiteral():
                return self.function_literal(node)
        raise TypeError(f"not an expression: {node}")

    def scoped_cell(self, node: tree.Scoped) -> ast.expr:
        """The cell of ``local.name`` or ``global.name``."""
        own = node.name in self.local_names or node.name in self.parameters
        symbol = self.emit.at(node).attribute(self.symbol(node.name), "undeclared")
        if node.scope == "global":
            outer = self.emit.name(f"o_{node.name}") if own else self.emit.constant(None)
            return self.emit.call("global_cell", self.symbol(node.name), outer)
        if own:
            return self.emit.either(self.emit.name(f"l_{node.name}"), symbol)
        return self.cell(node.name) if self.is_file else symbol

    def condition(self, node: tree.Expression) -> ast.expr:
        """An expression as a Python truth."""
        while isinstance(node, tree.Paren):
            node = node.inner
        if isinstance(node, tree.Binary) and node.operator in _RELATIONS and constant(node) is None:
            return self._relation(node)
        return self._truth(self.value(node))

    def _truth(self, value: ast.expr) -> ast.expr:
        """Whether a value counts as true."""
        name = self.unit.unique("t")
        number = self.emit.unary(ast.Not(), self._nearly_zero(self.emit.name(name), ast.LtE()))
        test = self.is_float(self.emit.named(name, value))
        return self.emit.conditional(test, number, self.emit.call("truth", self.emit.name(name)))

    def is_float(self, *values: ast.expr) -> ast.expr:
        """Whether all of these are floats; all are worked out, whatever they are."""
        kinds = [self.emit.attribute(value, "__class__") for value in values]
        return self.emit.compare(kinds[0], ast.Is(), *kinds[1:], self.emit.name("float"))

    def _nearly_zero(self, number: ast.expr, order: ast.cmpop) -> ast.expr:
        """Whether a float is zero but for `EPSILON`."""
        return self.emit.compare(self.emit.constant(-EPSILON), order, number, self.emit.constant(EPSILON))

    def _characters(self, raw: str) -> ast.expr:
        """A string that is not all ASCII: where the scene's charset is ASCII, POV-Ray reads a blank for every byte."""
        encoding = "utf-8" if self.unit.utf8 else "latin-1"
        blanked = "".join(c if c.isascii() else " " * len(c.encode(encoding)) for c in raw)
        return self.emit.call("characters", self.emit.constant(unescape(raw)), self.emit.constant(unescape(blanked)))

    def _variable(self, name: str) -> ast.expr:
        return self.emit.call("variable", self.emit.constant(name))

    def _unary(self, node: tree.Unary) -> ast.expr:
        operand = self.expression(node.operand)
        self.emit.at(node)
        if node.operator == "!":
            return self.emit.call("not_", operand)
        return self.emit.unary(ast.USub() if node.operator == "-" else ast.UAdd(), operand)

    def _binary(self, node: tree.Binary) -> ast.expr:
        if node.operator in _RELATIONS:
            relation = self._relation(node)
            return self.emit.binary(relation, ast.Mult(), self.emit.constant(1.0))
        if node.operator in _PYTHON:
            left, right = self.expression(node.left), self.expression(node.right)
            self.emit.at(node)
            return self.emit.binary(left, _PYTHON[node.operator](), right)
        if node.operator == "/":
            divisor = constant(node.right)
            left, right = self.expression(node.left), self.expression(node.right)
            self.emit.at(node)
            if isinstance(divisor, float) and divisor:
                return self.emit.binary(left, ast.Div(), right)
            return self.emit.call("divide", left, right)
        left, right = self.value(node.left), self.value(node.right)
        self.emit.at(node)
        return self.emit.call(_HELPERS[node.operator], left, right)

    def _relation(self, node: tree.Binary) -> ast.expr:
        left, right = self.value(node.left), self.value(node.right)
        self.emit.at(node)
        if node.operator in _ORDER:
            return self.emit.compare(left, _ORDER[node.operator](), right)
        return self._tolerant(node, left, right)

    def _tolerant(self, node: tree.Binary, left: ast.expr, right: ast.expr) -> ast.expr:
        """A relation that overlooks `EPSILON`: arithmetic where both sides are floats, else its helper's affair."""
        values, tested = [left, right], []
        for side, operand in enumerate((node.left, node.right)):
            if not isinstance(constant(operand), float):
                name = self.unit.unique("t")
                tested.append(self.emit.named(name, values[side]))
                values[side] = self.emit.name(name)
        a, b = values
        more, less = (b, a) if node.operator == ">=" else (a, b)
        difference = self.emit.binary(more, ast.Sub(), less)
        if node.operator in ("=", "!="):
            holds = self._nearly_zero(difference, ast.Lt())
        else:
            holds = self.emit.compare(difference, ast.Lt(), self.emit.constant(EPSILON))
        holds = self.emit.either(holds, self.emit.compare(a, ast.Eq(), b))  # two infinities have no difference
        if node.operator == "!=":
            holds = self.emit.unary(ast.Not(), holds)
        other = self.emit.call(_HELPERS[node.operator], a, b)
        return self.emit.conditional(self.is_float(*(tested or values)), holds, other)

    def _conditional(self, node: tree.Conditional) -> ast.expr:
        test = self.condition(node.condition)
        yes, no = self.value(node.yes), self.value(node.no)
        self.emit.at(node)
        if _is_plain(node.yes) and _is_plain(node.no):
            return self.emit.conditional(test, yes, no)
        return self.emit.call("choose", test, yes, no)

    def _member(self, node: tree.Member) -> ast.expr:
        of = self.expression(node.of)
        self.emit.move(node.end_line, node.end_column)
        if COMPONENTS.get(node.name) == 0:
            return self._first_component(of, node.name)
        if node.name in COMPONENTS or node.name == "gray":
            return self.emit.attribute(of, node.name)
        return self.emit.call("member", of, self.emit.constant(node.name))

    def _first_component(self, of: ast.expr, component: str) -> ast.expr:
        """The first component of a vector, which numbers have too."""
        name = self.unit.unique("t")
        number = self.emit.name(name)
        is_float = self.is_float(self.emit.named(name, of))
        return self.emit.conditional(is_float, number, self.emit.attribute(number, component))

    def _subscript(self, node: tree.Subscript) -> ast.expr:
        container, indices = self.element(node)
        self.emit.at(node.index)
        return self.emit.call(self.emit.attribute(container, "fetch"), *indices)

    def element(self, node: tree.Subscript | tree.Member) -> tuple[ast.expr, list[ast.expr]]:
        """The container of an element, and all the subscripts that lead to it."""
        indices: list[ast.expr] = []
        of: tree.Expression = node
        while isinstance(of, tree.Subscript) or (isinstance(of, tree.Member) and of.name not in COMPONENTS):
            if isinstance(of, tree.Subscript):
                indices.insert(0, self.value(of.index))
            else:
                indices.insert(0, self.emit.constant(of.name))
            of = of.of
        return self.value(of), indices

    def _vector(self, node: tree.Vector) -> ast.expr:
        parts = [item for item in node.items if not is_comma(item)]
        if not all(isinstance(part, EXPRESSIONS) for part in parts):
            return self._gathered(node)
        splices = any(map(may_splice, parts))
        if splices and len(node.items) != 2 * len(parts) - 1:
            tokens = self.tokens(node.items)
            return self.emit.at(node).call("spliced_vector", tokens)
        terms = [self.expression(part) for part in parts]  # type: ignore[arg-type]  # expressions, as just seen
        self.emit.at(node)
        if splices:
            return self.emit.call("separated_vector", *terms)
        return self.emit.call("vector3" if len(terms) == 3 else "vector", *terms)

    def tokens(self, items: Sequence[tree.Item]) -> ast.expr:
        """Expressions and the commas between them, as a tuple; macros may have left more in them."""
        values = []
        for item in items:
            if is_comma(item):
                values.append(self.emit.at(item).name(self.unit.constants.add(("punctuation", ","))))
            else:
                values.append(self.expression(item))  # type: ignore[arg-type]  # only expressions and commas are asked for
        return self.emit.tuple(values)

    def _gathered(self, node: tree.Vector) -> ast.expr:
        """A vector with directives among its terms."""
        sink = self.gather(node.items, "<", node)
        return self.emit.at(node).call("gathered_vector", self.emit.name(sink))

    def _group(self, node: tree.Group) -> ast.expr:
        """Parentheses with directives inside."""
        sink = self.gather(node.items, "(", node)
        return self.emit.at(node).call("gathered_value", self.emit.name(sink))

    def gather(self, items: Sequence[tree.Item], name: str, node: tree.Node) -> str:
        """The variable of a sink into which ``items`` went."""
        self.emit.at(node)
        sink = self.kept(self.emit.call("collect", self.emit.constant(name), self.place(node)), "sink")
        with self.inside(gathering=name in ("<", "(", "call")):
            self.items(items)
        self.do("collected", self.emit.name(sink))
        return sink


def _is_plain(node: tree.Expression) -> bool:
    """Whether working an expression out can neither fail nor do anything."""
    if isinstance(node, tree.Paren | tree.Unary):
        return _is_plain(node.inner if isinstance(node, tree.Paren) else node.operand)
    return constant(node) is not None or isinstance(node, tree.Name)
