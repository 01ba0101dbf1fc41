"""The names that a text declares and uses.

``#declare``, ``#local``, ``#macro``, ``#for``, ``#fopen``, the parameters of macros and functions.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final, Literal, TypeAlias

from lark import Token
from minipov.editor.analysis.document import Document
from minipov.editor.analysis.scanning import comments
from minipov.editor.analysis.statements import Statement
from minipov.grammar.keywords import OPENING

NameKind: TypeAlias = Literal["macro", "function", "value", "parameter", "counter", "file"]


@dataclass(frozen=True, slots=True)
class Declaration:
    """A name where it is declared.

    ``start`` to ``end`` is the name itself, ``from_`` to ``to`` the whole declaration; ``scope`` is where a local name
    holds, None everywhere from here on: ``in_file`` says that it ends with its file, as ``#local`` outside macros does.
    ``value`` is the word that its value begins with (``texture``, ``rgb``).
    """

    name: str
    kind: NameKind
    start: int
    end: int
    from_: int
    to: int
    scope: tuple[int, int] | None = None
    value: str = ""
    parameters: tuple[str, ...] = ()
    comment: str = ""
    in_file: bool = False

    def moved(self, by: int) -> Declaration:
        """The same declaration further down the text."""
        scope = self.scope and (self.scope[0] + by, self.scope[1] + by)
        return replace(
            self, start=self.start + by, end=self.end + by, from_=self.from_ + by, to=self.to + by, scope=scope
        )


@dataclass(frozen=True, slots=True)
class Include:
    """The string behind ``#include``, its quotes excluded."""

    file: str
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Names:
    """What one statement declares, uses and includes; ``computed_include`` says that a file name is an expression."""

    declared: tuple[Declaration, ...]
    used: tuple[Token, ...]
    includes: tuple[Include, ...]
    computed_include: bool


def names_in(statement: Statement) -> Names:
    """The names of a statement, at offsets from its start."""
    return statement.known("names", lambda statement: _Reader(statement).read())


def declarations(document: Document) -> Iterator[Declaration]:
    """All of a text, from top to bottom."""
    for start, statement in document.placed():
        for declaration in names_in(statement).declared:
            yield declaration.moved(start)


def includes(document: Document) -> Iterator[Include]:
    """All files that a text names."""
    for start, statement in document.placed():
        for include in names_in(statement).includes:
            yield Include(include.file, include.start + start, include.end + start)


def globals_of(document: Document) -> dict[str, Declaration]:
    """The names that hold outside macros too; of several declarations of a name, the first."""
    return document.known("globals", lambda document: _first_of_each(d for d in declarations(document) if not d.scope))


def exports_of(document: Document) -> dict[str, Declaration]:
    """Those of them that hold in texts that include this one."""
    return document.known("exports", lambda document: _first_of_each(_exports(document)))


def _exports(document: Document) -> Iterator[Declaration]:
    return (d for d in declarations(document) if not d.scope and not d.in_file)


def _first_of_each(found: Iterable[Declaration]) -> dict[str, Declaration]:
    table: dict[str, Declaration] = {}
    for declaration in found:
        table.setdefault(declaration.name, declaration)
    return table


def local_at(document: Document, name: str, offset: int) -> Declaration | None:
    """The declaration of a local name or parameter that holds at an offset: that of the innermost scope."""
    start, statement = document.at(offset)
    found = [d for d in names_in(statement).declared if d.name == name and _holds(d, offset - start)]
    found.sort(key=lambda d: d.scope[1] - d.scope[0] if d.scope else 0)
    return found[0].moved(start) if found else None


def locals_at(document: Document, offset: int) -> list[Declaration]:
    """All local names and parameters that hold at an offset."""
    start, statement = document.at(offset)
    return [d.moved(start) for d in names_in(statement).declared if _holds(d, offset - start)]


def _holds(declaration: Declaration, offset: int) -> bool:
    return declaration.scope is not None and declaration.scope[0] <= offset <= declaration.scope[1]


_VALUE_KINDS: Final = {"NUMBER": "float", "STRING": "string", "LESS": "vector", "BULK": "vector"}


class _Reader:
    """Walks over the tokens of a statement."""

    def __init__(self, statement: Statement) -> None:
        self.text = statement.text
        self.tokens: Sequence[Token] = statement.tokens
        self.declared: list[Declaration] = []
        self.used: list[Token] = []
        self.includes: list[Include] = []
        self.computed = False
        self.reading = ""
        self.ends = _ends(statement.tokens)

    def read(self) -> Names:
        macros: list[tuple[int, int]] = []
        previous = ""
        for at, token in enumerate(self.tokens):
            kind, start = token.type, token.start_pos or 0
            self.reading = kind
            while macros and start >= macros[-1][1]:
                macros.pop()
            if kind in {"DECLARE", "LOCAL"}:
                self._declare(at, macros[-1] if macros and kind == "LOCAL" else None)
            elif kind == "MACRO":
                scope = (start, self.ends.get(at, len(self.text)))
                self._macro(at, scope)
                macros.append(scope)
            elif kind == "FOR":
                self._add(at + 2, "counter", at, at + 2, macros[-1] if macros else None)
            elif kind == "FOPEN":
                self._add(at + 1, "file", at, at + 1, None)
            elif kind == "READ":
                self._read_targets(at)
            elif kind == "FUNCTION_WORD":
                self._function_parameters(at)
            elif kind == "INCLUDE":
                self._include(at)
            elif kind == "NAME" and previous != "DOT":
                self.used.append(token)
            previous = kind
        return Names(tuple(self.declared), tuple(self.used), tuple(self.includes), self.computed)

    def _kind(self, at: int) -> str:
        return self.tokens[at].type if at < len(self.tokens) else ""

    def _add(
        self, at: int, kind: NameKind, first: int, last: int, scope: tuple[int, int] | None,
        value: str = "", parameters: tuple[str, ...] = (),
    ) -> None:  # fmt: skip
        if self._kind(at) != "NAME":
            return
        token, start = self.tokens[at], self.tokens[first].start_pos or 0
        end = self.tokens[min(last, len(self.tokens) - 1)].end_pos or 0
        comment = self._comment_before(first)
        name = str(token.value)
        in_file = scope is None and self.reading in {"LOCAL", "FOR"}
        place = (token.start_pos or 0, token.end_pos or 0, start, end)
        self.declared.append(Declaration(name, kind, *place, scope, value, parameters, comment, in_file))

    def _declare(self, at: int, scope: tuple[int, int] | None) -> None:
        """``#declare deprecated once "text" NAME = ...``, or several targets in brackets."""
        name = at + 1
        while self._kind(name) in {"DEPRECATED", "ONCE", "STRING"}:
            name += 1
        if self._kind(name) in {"LPAR", "LESS", "LBRACE"}:
            while (name := name + 1) < len(self.tokens) and self._kind(name) != "EQUAL":
                if self._kind(name - 1) in {"LPAR", "LESS", "LBRACE", "COMMA", "OPTIONAL"}:
                    self._add(name, "value", name, name, scope)
            return
        first = name + 1
        if self._kind(first) != "EQUAL":
            return
        value = self.tokens[first + 1] if first + 1 < len(self.tokens) else None
        is_function = value is not None and value.type == "FUNCTION_WORD"
        parameters = self._names_between(first + 2) if is_function else ()
        word = _VALUE_KINDS.get(value.type, str(value.value)) if value is not None else ""
        self._add(name, "function" if is_function else "value", at, self._value_end(first + 1), scope, word, parameters)

    def _value_end(self, at: int) -> int:
        """The last token of a declaration's value, which begins at ``at``."""
        while at < len(self.tokens):
            kind = self._kind(at)
            if kind == "SEMICOLON":
                return at
            end = self.ends.get(at)
            if kind == "LBRACE" and end is not None:
                while at + 1 < len(self.tokens) and (self.tokens[at + 1].start_pos or 0) < end:
                    at += 1
                return at + 1 if self._kind(at + 1) == "SEMICOLON" else at
            if kind in OPENING:
                return at
            at += 1
        return len(self.tokens) - 1

    def _macro(self, at: int, scope: tuple[int, int]) -> None:
        parameters = self._names_between(at + 2)
        last = at
        while last + 1 < len(self.tokens) and (self.tokens[last + 1].start_pos or 0) < scope[1]:
            last += 1
        self._add(at + 1, "macro", at, last, None, "", parameters)
        self._parameters(at + 2, scope)

    def _function_parameters(self, at: int) -> None:
        if self._kind(at + 1) != "LPAR":
            return
        closing = self._closing(at + 1)
        end = self.ends.get(closing + 1)
        if end is not None:
            self._parameters(at + 1, (self.tokens[at].start_pos or 0, end))

    def _parameters(self, at: int, scope: tuple[int, int]) -> None:
        for index in range(at + 1, self._closing(at)):
            self._add(index, "parameter", index, index, scope)

    def _names_between(self, at: int) -> tuple[str, ...]:
        """The names in the parentheses that open at ``at``, with the ``optional`` before them."""
        if self._kind(at) != "LPAR":
            return ()
        names: list[str] = []
        for index in range(at + 1, self._closing(at)):
            if self._kind(index) in {"NAME", "CONSTANT", "WORD"}:
                optional = "optional " if self._kind(index - 1) == "OPTIONAL" else ""
                names.append(optional + str(self.tokens[index].value))
        return tuple(names)

    def _closing(self, at: int) -> int:
        while at < len(self.tokens) and self._kind(at) not in {"RPAR", "LOOSE_RPAR"}:
            at += 1
        return at

    def _read_targets(self, at: int) -> None:
        for index in range(at + 3, self._closing(at)):
            self._add(index, "value", at, index, None)

    def _include(self, at: int) -> None:
        if self._kind(at + 1) == "STRING":
            token = self.tokens[at + 1]
            self.includes.append(Include(str(token.value), (token.start_pos or 0) + 1, (token.end_pos or 0) - 1))
        else:
            self.computed = True

    def _comment_before(self, at: int) -> str:
        """The text of the comments on the lines just above a token."""
        stop = self.tokens[at].start_pos or 0
        begin = (self.tokens[at - 1].end_pos or 0) if at else 0
        found = list(comments(self.text, begin, stop))
        lines: list[str] = []
        for start, end in reversed(found):
            own_line = not self.text[self.text.rfind("\n", 0, start) + 1 : start].strip()
            if self.text.count("\n", end, stop) > 1 or not own_line:
                break
            lines[:0] = (line.strip(" \t/*") for line in self.text[start:end].splitlines())
            stop = start
        return "\n".join(line for line in lines if any(map(str.isalnum, line)))


def _ends(tokens: Sequence[Token]) -> dict[int, int]:
    """For each opening brace and directive, by its index, the offset where it ends."""
    ends: dict[int, int] = {}
    stack: list[int] = []
    for at, token in enumerate(tokens):
        kind = token.type
        if kind == "LBRACE" or kind in OPENING:
            stack.append(at)
        elif stack and (kind == "END" or (kind == "RBRACE" and tokens[stack[-1]].type == "LBRACE")):
            ends[stack.pop()] = token.end_pos or 0
    return ends
