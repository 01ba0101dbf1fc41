"""SDL: ``#if``, ``#while``, ``#for``, ``#switch``, ``#macro``, ``#include``, ``#debug``, ``#fopen`` ...: directives."""

from __future__ import annotations

import ast
from abc import abstractmethod
from collections.abc import Sequence

from minipov.grammar import tree
from minipov.interpreter.compiler.declarations import Declarations
from minipov.interpreter.compiler.shapes import EXPRESSIONS, argument_groups, constant
from minipov.interpreter.values import EPSILON

_PART_OF_VALUES = (tree.If, tree.While, tree.For, tree.Switch, tree.Break, tree.Include)


class Directives(Declarations):
    """Compiles directives."""

    loops = 0
    """How many loops and switches of this function are open: what ``#break`` may leave."""

    def directive(self, items: Sequence[tree.Item], at: int) -> int:
        """Statements for the directive ``items[at]``; gives the index after it."""
        node = items[at]
        self.emit.at(node)
        if self.pending and not isinstance(node, _PART_OF_VALUES):
            self.do("settle")
        match node:
            case tree.Declare():
                return self.declare(items, at)
            case tree.Undef():
                self.undef(node)
            case tree.If():
                self._if(node)
            case tree.While():
                self._while(node)
            case tree.For():
                self._for(node)
            case tree.Switch():
                self._switch(node)
            case tree.Break():
                self._break(node)
            case tree.Macro():
                self.macro(node)
            case _:
                self._simple(node)
        return at + 1

    @abstractmethod
    def macro(self, node: tree.Macro) -> None:
        """``#macro``: a function of its own."""

    # --- choices ---

    def _if(self, node: tree.If) -> None:
        self._branches(node.branches, node.otherwise)

    def _branches(self, branches: Sequence[tree.Branch], otherwise: Sequence[tree.Item] | None) -> None:
        if not branches:
            self.items(otherwise or ())
            return
        branch = branches[0]
        if branch.defined is None:
            test = self.condition(branch.condition)
        else:
            test = self.is_defined(branch.condition)
            if not branch.defined:
                test = self.emit.unary(ast.Not(), test)
        with self.block() as body:
            self.items(branch.items)
        with self.block() as orelse:
            self._branches(branches[1:], otherwise)
        self.emit.at(branch)
        self.add(self.emit.if_(test, body, orelse))

    def _switch(self, node: tree.Switch) -> None:
        """A loop that runs once, so that ``#break`` can leave it; a case entered falls into the next."""
        value = self.kept(self.value(node.value))
        entered = self.kept(self.emit.constant(False))
        with self.block() as cases:
            self.loops += 1
            for case in node.cases:
                self._case(case, value, entered)
            self.loops -= 1
            self.add(self.emit.break_())
        self.emit.at(node)
        self.add(self.emit.while_(self.emit.constant(True), cases))

    def _case(self, case: tree.Case, value: str, entered: str) -> None:
        self.emit.at(case)
        if case.low is None:
            self.items(case.items)
            return
        low = self.value(case.low)
        high = low if case.high is None else self.value(case.high)
        self.emit.at(case)
        arguments = [self.emit.name(value), low, *([] if case.high is None else [high])]
        inside = self.emit.call("in_range" if case.high is not None else "is_case", *arguments)
        test: ast.expr = self.emit.either(self.emit.name(entered), inside)
        with self.block() as body:
            self.add(self.emit.assign(entered, self.emit.constant(True)))
            self.items(case.items)
        self.emit.at(case)
        self.add(self.emit.if_(test, body, []))

    # --- loops ---

    def _while(self, node: tree.While) -> None:
        with self.block() as before:
            test = self.condition(node.condition)
        self.emit.at(node)
        with self.block() as body:
            if before:
                self.statements += before
                self.add(self.emit.if_(test, [], [self.emit.break_()]))
                test = self.emit.constant(True)
            self.loops += 1
            self.items(node.items)
            self.loops -= 1
        self.emit.at(node)
        self.add(self.emit.while_(test, body))

    def _for(self, node: tree.For) -> None:
        """The bounds are worked out once; the variable is read anew at each turn."""
        name = tree.Name(node.line, node.column, node.name)
        start = self.kept(self.value(node.start))
        known = 1.0 if node.step is None else constant(node.step)
        end = self.value(node.end)
        if isinstance(known, float) and known:
            step: ast.expr = self.emit.at(node).constant(known)
            slack = self.emit.constant(EPSILON if known > 0 else -EPSILON)
            limit = self.emit.name(self.kept(self.emit.binary(end, ast.Add(), slack)))
            order: ast.cmpop = ast.Lt() if known > 0 else ast.Gt()
            test = self.emit.compare(self._loop_value(node), order, limit)
        else:
            limit = self.emit.name(self.kept(end))
            given = self.emit.constant(known) if node.step is None or known is not None else self.value(node.step)
            step = self.emit.name(self.kept(self.emit.at(node.step or node).call("loop_step", given)))
            test = self.emit.call("loop_goes_on", self._loop_value(node), limit, step)
        self.assign(name, self.emit.name(start), node, local=True)
        with self.block() as body:
            self.loops += 1
            self.items(node.items)
            self.loops -= 1
            self.emit.at(node)
            next_value = self.emit.binary(self._loop_value(node), ast.Add(), step)
            self.add(self.emit.set(self.cell(node.name), "v", next_value))
        self.emit.at(node)
        self.add(self.emit.while_(test, body))

    def _loop_value(self, node: tree.For) -> ast.expr:
        return self.emit.attribute(self.cell(node.name), "v")

    def _break(self, node: tree.Break) -> None:
        if self.loops:
            self.add(self.emit.break_())
        else:
            self.do("fail", self.emit.constant("#break stands in no loop, #switch or macro"), self.emit.constant(None))

    # --- the rest ---

    def _simple(self, node: tree.Item) -> None:
        match node:
            case tree.Include(file=file):
                self._file_call("include", file, node)
            case tree.Print(stream=stream, text=text):
                name = stream if stream in ("warning", "error") else "debug"
                self._told(f"print_{name}", text, node)
                if stream in ("render", "statistics"):
                    self.do("obsolete", self.emit.constant(f"#{stream}"), self.emit.constant("#debug"))
            case tree.Version(value=value):
                self._told("set_version", value, value)
            case tree.Obsolete(name=name, value=value):
                given = self.value(value)
                self.emit.at(node)
                self.do("obsolete_setting", self.emit.constant(name), given)
            case tree.Default(block=block):
                self.block_items("#default", block, node)
            case tree.FileOpen(name=name, file=file, mode=mode):
                path = self.file_name(file)
                self.emit.at(file)
                self.do("open_file", self.symbol(name), path, self.emit.constant(mode), self.place(node))
            case tree.FileClose(name=name):
                self.do("close_file", self.symbol(name))
            case tree.FileRead():
                self._read(node)
            case tree.FileWrite():
                self._write(node)
            case tree.FileWriteOpen(name=name):
                self.do("begin_write", self.symbol(name), self.place(node))
            case _:
                raise TypeError(f"not a directive: {node}")

    def file_name(self, node: tree.Expression) -> ast.expr:
        """A string that names a file: its backslashes are no escapes."""
        if isinstance(node, tree.String):
            return self.emit.at(node).constant(node.raw)
        return self.value(node)

    def _file_call(self, function: str, file: tree.Expression, node: tree.Node) -> None:
        value = self.file_name(file)
        self.emit.at(file)
        self.do(function, value, self.place(file))

    def _told(self, function: str, argument: tree.Expression, node: tree.Node) -> None:
        value = self.value(argument)
        self.emit.at(argument)
        self.do(function, value, self.place(node))

    def _read(self, node: tree.FileRead) -> None:
        for target in node.targets:
            value = self.emit.at(node).call("read_file", self.symbol(node.name))
            kept = self.kept(value)
            with self.block() as body:
                if isinstance(target, tree.Name):
                    self.do("check_kind", self.cell(target.name), self.emit.name(kept))
                self.assign(target, self.emit.name(kept), node, local=False)
            found = self.emit.compare(self.emit.name(kept), ast.IsNot(), self.emit.constant(None))
            self.add(self.emit.if_(found, body, []))
        self.emit.at(node)
        self.do("end_read", self.symbol(node.name))

    def _write(self, node: tree.FileWrite) -> None:
        binary: str | None = None
        groups: list[list[tree.Item]] = [[]]
        for item in node.items:
            if isinstance(item, tree.Punctuation):
                groups.append([])
            else:
                groups[-1].append(item)
        for group in groups:
            binary = None
            rest: list[tree.Item] = []
            for item in group:
                if isinstance(item, tree.Keyword):
                    binary = item.name
                else:
                    rest.append(item)
            self._write_group(node, rest, binary)

    def _write_group(self, node: tree.FileWrite, group: Sequence[tree.Item], binary: str | None) -> None:
        split = argument_groups(group)
        if split is None or not all(len(part) == 1 and isinstance(part[0], EXPRESSIONS) for part in split):
            sink = self.emit.name(self.gather(group, "call", node))
            self.do("write_gathered", self.symbol(node.name), sink, self.emit.constant(binary))
            return
        for part in split:
            value = self.expression(part[0])  # type: ignore[arg-type]  # expressions, as just seen
            self.emit.at(node)
            self.do("write_file", self.symbol(node.name), value, self.emit.constant(binary))
