"""SDL: what stands between directives: words, values, blocks, brackets. They are pushed, in runs where possible."""

from __future__ import annotations

import ast
from abc import abstractmethod
from collections.abc import Sequence

from minipov.grammar import tree
from minipov.interpreter.compiler.constants import Plain, plain_array
from minipov.interpreter.compiler.function_literals import FunctionLiterals
from minipov.interpreter.compiler.shapes import DIRECTIVES, EXPRESSIONS, constant, is_comma, may_splice, parted
from minipov.interpreter.errors import Place


class Run:
    """Items to push together: constants as plain data, others as code."""

    def __init__(self) -> None:
        self.entries: list[tuple[Plain | None, ast.expr | None, Place]] = []

    def add(self, plain: Plain | None, code: ast.expr | None, place: Place) -> None:
        """One more item."""
        self.entries.append((plain, code, place))


class Items(FunctionLiterals):
    """Compiles sequences of items into statements that push them."""

    @abstractmethod
    def directive(self, items: Sequence[tree.Item], at: int) -> int:
        """Statements for the directive ``items[at]``; gives the index after it (and after a declaration's value)."""

    def items(self, items: Sequence[tree.Item]) -> None:
        """Statements that push items, and do what directives among them say."""
        run = Run()
        at = 0
        while at < len(items):
            at = self.one(items, at, run)
        self.flush(run)

    def one(self, items: Sequence[tree.Item], at: int, run: Run) -> int:
        """Statements for ``items[at]`` and what belongs to it; gives the index after that."""
        item = items[at]
        if isinstance(item, DIRECTIVES):
            self.flush(run)
            return self.directive(items, at)
        if isinstance(item, tree.Keyword):
            return self._keyword(items, at, run)
        for part in parted(item) or (item,):
            self._item(part, run)
        return at + 1

    def flush(self, run: Run) -> None:
        """Push a run."""
        entries, run.entries = run.entries, []
        if not entries:
            return
        places = tuple(place for _, _, place in entries)
        self.emit.move(places[0][1], places[0][2])
        if all(code is None for _, code, _ in entries) and len(entries) > 1:
            values = self.emit.name(self.unit.constants.add(("run", tuple(plain for plain, _, _ in entries))))
            self.do("extend", values, self.emit.constant(places))
            return
        codes = [self._revived(plain) if code is None else code for plain, code, _ in entries]
        self.emit.move(places[0][1], places[0][2])
        if len(codes) == 1:
            self.do("push", codes[0], self.emit.constant(places[0]))
        else:
            self.do("extend", self.emit.tuple(codes), self.emit.constant(places))

    def _revived(self, plain: Plain) -> ast.expr:
        if isinstance(plain, tuple):
            return self.emit.name(self.unit.constants.add(plain))
        return self.emit.constant(plain)

    def _keyword(self, items: Sequence[tree.Item], at: int, run: Run) -> int:
        word = items[at]
        assert isinstance(word, tree.Keyword)
        if word.name == "array":
            value, end = self.array(items, at, run)
            run.add(None, value, self.at(word))
            return end
        following = items[at + 1] if at + 1 < len(items) else None
        if word.name == "dictionary" and not isinstance(following, tree.Block):
            run.add(None, self.emit.at(word).call("Dictionary"), self.at(word))
            return at + 1
        if isinstance(following, tree.Block):
            self.flush(run)
            self.block_items(word.name, following, word)
            return at + 2
        run.add(("word", word.name), None, self.at(word))
        return at + 1

    def block_items(self, name: str, block: tree.Block, word: tree.Node) -> None:
        """``name { ... }``."""
        self.emit.at(word)
        self.do("open_block", self.emit.constant(name), self.place(word))
        with self.inside(gathering=False):
            self.items(block.items)
        self._close(block)

    def _close(self, block: tree.Block) -> None:
        self.emit.move(block.end_line, block.end_column)
        self.do("close_block", self.emit.constant((self.unit.path, block.end_line, block.end_column)))

    def _item(self, item: tree.Item, run: Run) -> None:
        known = constant(item)
        if self.gathering and has_open_terms(item):
            self.flush(run)
            self._push_terms(item)  # type: ignore[arg-type]  # only expressions have open terms
        elif known is not None:
            run.add(("vector", tuple(known)) if isinstance(known, tuple) else known, None, self.at(item))
        elif isinstance(item, tree.Call):
            self.flush(run)
            self.run_call(item)
        elif isinstance(item, tree.Group) and any(map(is_comma, item.items)):
            self.flush(run)
            self.items(item.items)
        elif isinstance(item, EXPRESSIONS):
            self._expression_item(item, run)
        elif isinstance(item, tree.Punctuation):
            run.add(("punctuation", item.text), None, self.at(item))
        elif isinstance(item, tree.FunctionName):
            run.add(None, self.function_name(item), self.at(item))
        elif isinstance(item, tree.Statements):
            self.flush(run)
            self.statements_alike(item)
        elif isinstance(item, tree.BulkVectors):
            run.add(plain_array(item.values), None, self.at(item))
        else:
            self.flush(run)
            self._bracketed(item)

    def _bracketed(self, item: tree.Item) -> None:
        match item:
            case tree.Block(items=items):
                self.emit.at(item)
                self.do("open_brace", self.place(item))
                with self.inside(gathering=False):
                    self.items(items)
                self._close(item)
            case tree.LooseBrace(opening=opening):
                self.emit.at(item)
                self.do("open_brace" if opening else "close_block", self.place(item))
            case tree.LooseOperator(operator=operator):
                self.emit.at(item)
                self.do("push", self.emit.name(_SIGNS[operator]), self.place(item))
            case tree.LooseParen():
                self.emit.at(item)
                self.do("end_write")
            case tree.Bracket(items=items):
                self.emit.at(item)
                self.do("open_bracket", self.place(item))
                with self.inside(gathering=False):
                    self.items(items)
                self.emit.at(item)
                self.do("close_bracket", self.place(item))
            case tree.Fault(error=error):
                self.emit.at(item)
                self.do("fail", self.emit.constant(error.message), self.emit.constant(error.hint))
            case _:
                raise TypeError(f"not an item: {item}")

    def _expression_item(self, item: tree.Expression, run: Run) -> None:
        if not self.opens or not has_open_terms(item):
            before = len(self.statements)
            with self.block() as statements:
                value = self.expression(item)
            if statements:
                self.flush(run)
                self.statements += statements
            if may_splice(item):
                self.flush(run)
                self.emit.at(item)
                self.do("push_all", value, self.place(item))
            else:
                run.add(None, value, self.at(item))
            assert before <= len(self.statements)
            return
        self.flush(run)
        self.emit.at(item)
        self.add(self.emit.if_(self.emit.name("open"), *self._both_ways(item)))

    def _both_ways(self, item: tree.Expression) -> tuple[list[ast.stmt], list[ast.stmt]]:
        """Pushing the open terms of an expression, and pushing its value."""
        with self.block() as opened:
            self._push_terms(item)
        with self.block() as closed:
            value = self.expression(item)
            self.emit.at(item)
            self.do("push_all" if may_splice(item) else "push", value, self.place(item))
        return opened, closed

    def _push_terms(self, item: tree.Expression) -> None:
        tokens = self.open_terms(item)
        self.emit.at(item)
        self.do("extend", self.emit.tuple(tokens), self.emit.constant((self.at(item),) * len(tokens)))

    def open_terms(self, node: tree.Expression) -> list[ast.expr]:
        """An expression as a row of values and operators."""
        match node:
            case tree.Binary(operator=operator, left=left, right=right) if operator in _SIGNS:
                tokens = self.open_terms(left)
                sign = self.emit.at(node).name(_SIGNS[operator])
                return [*tokens, sign, *self.open_terms(right)]
            case tree.Unary(operator=operator, operand=operand):
                sign = self.emit.at(node).name(_SIGNS[operator])
                return [sign, *self.open_terms(operand)]
        return [self.value(node)]

    def function_name(self, node: tree.FunctionName) -> ast.expr:
        """A name among the tokens of a function's body."""
        raise TypeError(f"not an item: {node}")

    @abstractmethod
    def statements_alike(self, node: tree.Statements) -> None:
        """Many statements of a few shapes."""

    @abstractmethod
    def array(self, items: Sequence[tree.Item], at: int, run: Run) -> tuple[ast.expr, int]:
        """``array[n] { ... }``; gives its value and the index after it."""


_SIGNS: dict[str, str] = {"+": "PLUS", "-": "MINUS", "*": "TIMES", "/": "OVER", "!": "NOT"}


def has_open_terms(node: tree.Item) -> bool:
    """Whether an operator stands outside all parentheses of an expression."""
    return isinstance(node, tree.Unary) or (isinstance(node, tree.Binary) and node.operator in _SIGNS)
