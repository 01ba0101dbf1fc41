"""SDL: ``#declare X = 1;``, ``#local A[i] = ...``, ``#undef X``, ``#for`` variables: giving names a meaning.

A local lives in the Python variables ``l_X`` (its cell, None before it exists) and ``o_X`` (what the name meant
before).
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence

from minipov.grammar import tree
from minipov.interpreter.compiler.array_literals import ArrayLiterals
from minipov.interpreter.compiler.shapes import EXPRESSIONS, is_semicolon, value_extent


class Declarations(ArrayLiterals):
    """Compiles declarations."""

    pending = False
    """Whether a declaration may wait for its value when a later directive is reached."""

    def declare(self, items: Sequence[tree.Item], at: int) -> int:
        """``#declare X =`` with the value after it; gives the index after that."""
        node = items[at]
        assert isinstance(node, tree.Declare)
        if node.bare:
            self.do("obsolete", self.emit.constant("declare"), self.emit.constant("#declare"))
        end = value_extent(items, at + 1)
        if end is None or node.form:
            return self._pending(node, items, at)
        group = items[at + 1 : end]
        value = self.rvalue(group, "declaration")
        ended = end < len(items) and is_semicolon(items[end])
        if not ended and _may_be_number(group):
            value = self.emit.at(group[0]).call("unended", value, self.place(group[-1]))
        if node.deprecated:
            self._deprecate(node, value)
        elif len(group) == 1 and isinstance(group[0], tree.FunctionLiteral):
            self._assign_fixed(node, value)
        else:
            self.assign(node.targets[0], value, node, local=node.local)
        return end + ended

    def _pending(self, node: tree.Declare, items: Sequence[tree.Item], at: int) -> int:
        """A declaration whose value only the running program knows: the next complete value is taken."""
        self.pending = True
        self.emit.at(node)
        taker = self.unit.unique("taker_")
        with self.block() as body:
            names = [t.name for t in node.targets if isinstance(t, tree.Name) and t.name in self.local_names]
            if node.local and names:
                self.add(self.emit.nonlocal_([f"{prefix}_{name}" for name in names for prefix in "lo"]))
            if node.form:
                self._tuple_targets(node)
            elif node.deprecated:
                self._deprecate(node, self.emit.name("value"))
            else:
                self.assign(node.targets[0], self.emit.name("value"), node, local=node.local)
        self.add(self.emit.at(node).function(taker, ["value"], body, opens=False))
        count = self.emit.constant(len(node.targets) if node.form else 0)
        self.do("begin_declaration", self.emit.name(taker), self.place(node), count)
        values = items[at + 1] if at + 1 < len(items) else None
        if node.form and isinstance(values, tree.Group):
            self.items(values.items)
            return at + 2
        return at + 1

    def _tuple_targets(self, node: tree.Declare) -> None:
        for number, target in enumerate(node.targets):
            if target is None:
                continue
            optional = bool(node.optional) and node.optional[number]
            given = self.emit.call(
                "part", self.emit.name("value"), self.emit.constant(number), self.emit.constant(optional)
            )
            name = self.kept(given)
            with self.block() as body:
                self.assign(target, self.emit.name(name), node, local=node.local)
            has = self.emit.compare(self.emit.name(name), ast.IsNot(), self.emit.name("UNSET"))
            self.add(self.emit.if_(has, body, []))

    def _deprecate(self, node: tree.Declare, value: ast.expr) -> None:
        target = node.targets[0]
        if not isinstance(target, tree.Name):
            self.assign(target, value, node, local=False)
            return
        text = self.emit.constant(f"'{target.name}' is deprecated")
        if node.deprecated_text is not None:
            text = self.value(node.deprecated_text)
        self.emit.at(node)
        deprecate = self.emit.attribute(self.symbol(target.name), "deprecate")
        self.add(self.emit.do(self.emit.call(deprecate, value, text, self.emit.constant(node.deprecated_once))))

    def _assign_fixed(self, node: tree.Declare, value: ast.expr) -> None:
        target = node.targets[0]
        if isinstance(target, tree.Name) and not (node.local and target.name in self.local_names):
            self.emit.at(target)
            self.add(self.emit.do(self.emit.call(self.emit.attribute(self.symbol(target.name), "fix"), value)))
        else:
            self.assign(target, value, node, local=node.local, fixed=True)

    def assign(
        self, target: tree.Expression | None, value: ast.expr, node: tree.Node, *, local: bool, fixed: bool = False
    ) -> None:
        """Give a name or array element a value."""
        self.emit.at(node)
        if isinstance(target, tree.Subscript | tree.Member):
            name = self.kept(value)
            container, indices = self.element(target)
            self.emit.at(target)
            method = self.emit.attribute(container, "assign")
            self.add(self.emit.do(self.emit.call(method, self.emit.name(name), *indices)))
        elif isinstance(target, tree.Scoped):
            self.add(self.emit.set(self.scoped_cell(target), "v", value))
        elif not isinstance(target, tree.Name):
            self.do("fail", *self._reserved(target or node))
        elif local and target.name in self.local_names:
            self._assign_local(target.name, value, fixed)
        else:
            self.add(self.emit.set(self.cell(target.name), "v", value))

    def _reserved(self, target: tree.Node) -> tuple[ast.expr, ast.expr]:
        """Message and hint for a declaration of what is no name."""
        self.emit.at(target)
        name = target.name if isinstance(target, tree.ConstantWord) else ""
        message = f"'{name}' is a reserved word and cannot be declared" if name else "expected a name"
        return self.emit.constant(message), self.emit.constant(f"'{name.capitalize()}' would do" if name else None)

    def _assign_local(self, name: str, value: ast.expr, fixed: bool) -> None:
        kept = self.emit.name(self.kept(value))
        own = self.emit.name(f"l_{name}")
        with self.block() as create:
            self.add(self.emit.assign(f"o_{name}", self.cell(name)))
            if fixed:
                cell = self.emit.call("FixedCell", self.emit.constant(name), kept, self.emit.name(f"o_{name}"))
            else:
                cell = self.emit.call("Cell", kept, self.emit.name(f"o_{name}"))
            self.add(self.emit.assign(f"l_{name}", cell))
            self.add(self.emit.set(self.symbol(name), "c", own))
        test = self.emit.compare(self.cell(name), ast.Is(), own)
        self.add(self.emit.if_(test, [self.emit.set(own, "v", kept)], create))

    def undef(self, node: tree.Undef) -> None:
        """``#undef X``: the innermost meaning goes; parameters stay."""
        target = node.target
        self.emit.at(node)
        if isinstance(target, tree.Subscript | tree.Member):
            container, indices = self.element(target)
            erase = self.emit.attribute(container, "erase")
            self.add(self.emit.do(self.emit.call(erase, *indices)))
        elif isinstance(target, tree.Name) and target.name not in self.parameters:
            self.emit.at(target)
            self.do("undefine", self.symbol(target.name))

    def enter_scope(self) -> None:
        """The start of a function: parameters take their names' place, locals do not exist yet."""
        for name in self.parameters:
            self.add(self.emit.assign(f"o_{name}", self.cell(name)))
            self.add(self.emit.set(self.symbol(name), "c", self.emit.name(f"l_{name}")))
        for name in sorted(self.local_names - set(self.parameters)):
            self.add(self.emit.assign(f"l_{name}", self.emit.constant(None)))
            self.add(self.emit.assign(f"o_{name}", self.emit.constant(None)))

    def leave_scope(self) -> None:
        """The end of a function: names mean again what they meant before."""
        for name in sorted(self.local_names - set(self.parameters)):
            test = self.emit.compare(self.emit.name(f"l_{name}"), ast.IsNot(), self.emit.constant(None))
            restore = self.emit.set(self.symbol(name), "c", self.emit.name(f"o_{name}"))
            self.add(self.emit.if_(test, [restore], []))
        for name in reversed(self.parameters):
            self.add(self.emit.set(self.symbol(name), "c", self.emit.name(f"o_{name}")))


def _may_be_number(group: Sequence[tree.Item]) -> bool:
    own_end = tree.FunctionLiteral | tree.Call  # a macro's body may bring the semicolon
    return len(group) == 1 and isinstance(group[0], EXPRESSIONS) and not isinstance(group[0], own_end)


def local_names(items: Sequence[tree.Item]) -> Iterator[str]:
    """The names that the items of one function make locals: ``#local`` and ``#for``, not inside nested macros."""
    for item in items:
        match item:
            case tree.Declare(local=True, targets=targets):
                yield from (target.name for target in targets if isinstance(target, tree.Name))
            case tree.For(name=name, items=inner):
                yield name
                yield from local_names(inner)
            case tree.If(branches=branches, otherwise=otherwise):
                for branch in branches:
                    yield from local_names(branch.items)
                yield from local_names(otherwise or ())
            case tree.Switch(cases=cases):
                for case in cases:
                    yield from local_names(case.items)
            case (
                tree.While(items=inner) | tree.Block(items=inner) | tree.Bracket(items=inner) | tree.Vector(items=inner)
            ):
                yield from local_names(inner)
            case tree.Call(items=inner) | tree.BuiltinCall(items=inner) | tree.FunctionBlock(items=inner):
                yield from local_names(inner)
            case tree.Default(block=block):
                yield from local_names(block.items)
            case tree.FunctionLiteral(body=tree.FunctionBlock(items=inner)):
                yield from local_names(inner)
