"""A whole file, and ``#macro M(A, B) ... #end``: each becomes a Python function of the file's module."""

from __future__ import annotations

import ast
from collections.abc import Sequence

from minipov.grammar import tree
from minipov.interpreter.compiler.body import Unit
from minipov.interpreter.compiler.constants import plain_array
from minipov.interpreter.compiler.declarations import local_names
from minipov.interpreter.compiler.directives import Directives
from minipov.interpreter.compiler.items import has_open_terms
from minipov.interpreter.compiler.program import ENTRY, Program
from minipov.interpreter.compiler.shapes import EXPRESSIONS
from minipov.interpreter.errors import SdlError
from minipov.interpreter.runtime.places import MACRO_PREFIX, SHAPE_PREFIX


class FileBody(Directives):
    """The items of a file."""

    def macro(self, node: tree.Macro) -> None:
        """``#macro``: a function of its own, entered under its name when this place is reached."""
        body = MacroBody(self.unit, node)
        name = body.compiled()
        self.emit.at(node)
        self.do(
            "define_macro",
            self.symbol(node.name),
            self.emit.constant(node.parameters),
            self.emit.constant(_least(node)),
            self.emit.name(name),
            self.emit.constant(body.returns),
            self.emit.constant(node.span),
        )

    def statements_alike(self, node: tree.Statements) -> None:
        """A function for each shape, called with the numbers of each statement."""
        shapes = []
        for items, numbers in zip(node.shapes, node.numbers, strict=True):
            body = FileBody(self.unit)
            body.items(items)
            holes = [f"n{index}" for index in range(numbers.shape[1])]
            name = self.unit.unique(SHAPE_PREFIX)
            self.unit.functions.append(body.emit.at(node).function(name, holes, body.statements, opens=False))
            shapes.append(name)
        self.emit.at(node)
        functions = self.emit.tuple([self.emit.name(name) for name in shapes])
        kept = ("rows", node.order, node.lines, tuple(plain_array(numbers) for numbers in node.numbers))
        calls = self.emit.constant(tuple(isinstance(items[0], tree.Call) for items in node.shapes))
        self.do("run_statements", functions, calls, self.emit.name(self.unit.constants.add(kept)))


class MacroBody(FileBody):
    """The items of a macro."""

    opens = True
    is_file = False

    def __init__(self, unit: Unit, node: tree.Macro) -> None:
        super().__init__(unit, node.parameters, local_names(node.items))
        self.node = node
        self.returns = gives_value(node.items)
        self.breaks = _has_break(node.items)

    def compiled(self) -> str:
        """The name of the function in the module."""
        self.emit.at(self.node)
        self.enter_scope()
        if self.returns:
            self._returning(self.node.items)
        elif self.breaks:
            self._breakable()
        else:
            self.items(self.node.items)
        self.emit.at(self.node)
        self.leave_scope()
        if self.returns:
            self.add(self.emit.return_(self.emit.name("result")))
        parameters = [f"l_{name}" for name in self.node.parameters]
        function = self.emit.function(MACRO_PREFIX + self.node.name, parameters, self.statements, opens=True)
        name = self.unit.unique("macro")
        self.unit.functions += [function, self.emit.assign(name, self.emit.name(MACRO_PREFIX + self.node.name))]
        return name

    def _breakable(self) -> None:
        """A loop that runs once, so that ``#break`` can leave it."""
        with self.block() as body:
            self.loops += 1
            self.items(self.node.items)
            self.loops -= 1
            self.add(self.emit.break_())
        self.emit.at(self.node)
        self.add(self.emit.while_(self.emit.constant(True), body))

    def _returning(self, items: Sequence[tree.Item]) -> None:
        """Items of which the last gives the macro's value."""
        *before, last = items
        self.items(before)
        if isinstance(last, tree.If):
            self._returning_if(last.branches, last.otherwise or ())
            return
        assert isinstance(last, EXPRESSIONS)
        if not has_open_terms(last):
            value = self.expression(last)
            self.add(self.emit.at(last).assign("result", value))
            return
        with self.block() as opened:
            tokens = self.open_terms(last)
            self.emit.at(last)
            self.add(self.emit.assign("result", self.emit.call("Spliced", self.emit.list(tokens))))
        with self.block() as closed:
            value = self.expression(last)
            self.add(self.emit.at(last).assign("result", value))
        self.add(self.emit.at(last).if_(self.emit.name("open"), opened, closed))

    def _returning_if(self, branches: Sequence[tree.Branch], otherwise: Sequence[tree.Item]) -> None:
        if not branches:
            self._returning(otherwise)
            return
        branch = branches[0]
        test = self.condition(branch.condition) if branch.defined is None else self.is_defined(branch.condition)
        if branch.defined is False:
            test = self.emit.unary(ast.Not(), test)
        with self.block() as body:
            self._returning(branch.items)
        with self.block() as orelse:
            self._returning_if(branches[1:], otherwise)
        self.emit.at(branch)
        self.add(self.emit.if_(test, body, orelse))


def _least(node: tree.Macro) -> int:
    """How many arguments a call must give: up to the last parameter that is not optional."""
    required = [number for number, optional in enumerate(node.optional, 1) if not optional]
    return required[-1] if required else 0 if node.optional else len(node.parameters)


def gives_value(items: Sequence[tree.Item]) -> bool:
    """Whether a macro's items do nothing but work out one value at their end."""
    if not items:
        return False
    *before, last = items
    if not all(_is_silent(items, at) for at in range(len(before))):
        return False
    if isinstance(last, tree.If):
        return last.otherwise is not None and all(map(gives_value, [*(b.items for b in last.branches), last.otherwise]))
    return isinstance(last, EXPRESSIONS) and not isinstance(last, tree.Call) and not _is_value_of_declare(items)


def _is_value_of_declare(items: Sequence[tree.Item]) -> bool:
    return len(items) > 1 and isinstance(items[-2], tree.Declare)


def _is_silent(items: Sequence[tree.Item], at: int) -> bool:
    """Whether an item pushes nothing, at whatever turn."""
    item = items[at]
    match item:
        case tree.If(branches=branches, otherwise=otherwise):
            return all(_all_silent(part) for part in [*(b.items for b in branches), otherwise or ()])
        case tree.While(items=inner) | tree.For(items=inner):
            return _all_silent(inner)
        case tree.Switch(cases=cases):
            return all(_all_silent(case.items) for case in cases)
        case tree.Declare():
            return at + 1 < len(items) and isinstance(items[at + 1], EXPRESSIONS) and not item.form
        case tree.Include() | tree.Break() | tree.Default():
            return False
        case tree.Punctuation(text=";"):
            return at > 1 and isinstance(items[at - 2], tree.Declare)
    if isinstance(item, EXPRESSIONS):
        return at > 0 and isinstance(items[at - 1], tree.Declare)
    return isinstance(item, _QUIET)


_QUIET = (
    tree.Undef, tree.Macro, tree.Version, tree.Print, tree.FileOpen, tree.FileClose, tree.FileRead, tree.FileWrite,
    tree.Obsolete,
)  # fmt: skip


def _all_silent(items: Sequence[tree.Item]) -> bool:
    return all(_is_silent(items, at) for at in range(len(items)))


def _has_break(items: Sequence[tree.Item]) -> bool:
    """Whether a ``#break`` stands outside loops and switches."""
    for item in items:
        if isinstance(item, tree.Break):
            return True
        if isinstance(item, tree.If):
            parts = [*(branch.items for branch in item.branches), item.otherwise or ()]
            if any(map(_has_break, parts)):
                return True
        elif isinstance(item, tree.Block) and _has_break(item.items):
            return True
    return False


def compile_file(file: tree.File, *, utf8: bool = True) -> Program:
    """A file's tree as code; ``utf8`` tells how the file writes what is not ASCII.

    Raises:
        SdlError: the file is nested too deeply for Python's compiler.
    """
    return finished(FileBody(Unit(file.path, utf8=utf8), (), local_names(file.items)), file)


def finished(body: FileBody, file: tree.File) -> Program:
    """The code of a file's items, to be compiled by ``body``."""
    unit = body.unit
    try:
        body.enter_scope()
        body.items(file.items)
        body.leave_scope()
        main = body.emit.function(ENTRY, (), body.statements, opens=False)
        module = ast.Module([*unit.functions, main], [])
        code = compile(module, file.path, "exec", dont_inherit=True, optimize=1)
    except (RecursionError, SyntaxError, MemoryError) as error:
        raise SdlError(f"this file is nested too deeply ({error})", (file.path, 1, 1)) from None
    return Program(file.path, code, tuple(sorted(unit.symbols)), tuple(unit.constants.plain))
