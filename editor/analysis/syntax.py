"""Mistakes in how a text is put together: characters, statements, braces."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from lark import Token
from minipov.editor.analysis.document import Document
from minipov.editor.analysis.parts import LARGE, Known, problems_by_parts
from minipov.editor.analysis.problem import Problem
from minipov.editor.analysis.recovery import parse
from minipov.editor.analysis.statements import Statement
from minipov.grammar.keywords import DIVIDING, OPENING


def tree_of(statement: Statement) -> tuple[Any, ...]:
    """The items of a statement, parsed once."""
    return _parsed(statement)[0]


def syntax_problems(document: Document) -> list[Problem]:
    """All of them, from top to bottom."""
    problems = [
        problem.moved(start)
        for start, statement in document.placed()
        for problem in (*statement.problems, *_problems(statement, document.parts))
    ]
    return sorted([*problems, *_stray_braces(document)], key=lambda problem: problem.start)


def _problems(statement: Statement, known: Known) -> list[Problem]:
    """What the parser says; where something could not even be read, the rest is likely a consequence."""
    if statement.problems:
        return []
    if len(statement.tokens) < LARGE:
        return _parsed(statement)[1]
    return statement.known("problems", lambda statement: problems_by_parts(statement, known))


def _parsed(statement: Statement) -> tuple[tuple[Any, ...], list[Problem]]:
    return statement.known("parsed", parse)


def _stray_braces(document: Document) -> Iterator[Problem]:
    """Braces without a partner, the outermost in each statement.

    The grammar takes them because the partner may stand in a branch of an ``#if``. Where all branches leave equally
    many braces open, as many may close after the ``#end``. Where branches differ, or a macro or loop leaves some open,
    nothing can be said about the rest of the file.
    """
    from_branches = 0
    for start, statement in document.placed():
        opened: list[Token] = []
        loose = statement.known("loose", _LooseBraces)
        for token in loose.outside:
            if token.value == "{":
                opened.append(token)
            elif opened:
                opened.pop()
            elif from_branches > 0:
                from_branches -= 1
            else:
                yield _brace(token, start, "this '}' closes nothing")
        if loose.unknown:
            return
        from_branches += loose.open
        for token in opened[:1]:
            yield _brace(token, start, "'{' is never closed", "add } where it should end")


def _brace(token: Token, start: int, message: str, hint: str | None = None) -> Problem:
    return Problem(start + (token.start_pos or 0), start + (token.end_pos or 0), message, hint)


class _LooseBraces:
    """The braces of a statement without a partner: those ``outside`` directives, and how many directives leave open."""

    def __init__(self, statement: Statement) -> None:
        self.outside: list[Token] = []
        self.open = 0
        self.unknown = False
        self._bodies: list[tuple[str, list[int]]] = []
        for token in statement.marked():
            self._take(token)

    def _take(self, token: Token) -> None:
        kind = token.type
        if kind in OPENING:
            self._bodies.append((kind, [0]))
        elif kind in {"LOOSE_LBRACE", "LOOSE_RBRACE"}:
            if self._bodies:
                self._bodies[-1][1][-1] += 1 if kind == "LOOSE_LBRACE" else -1
            else:
                self.outside.append(token)
        elif self._bodies and kind in DIVIDING:
            self._bodies[-1][1].append(0)
        elif self._bodies and kind == "END":
            self._close(*self._bodies.pop())

    def _close(self, kind: str, counts: list[int]) -> None:
        bodies = counts[1:] if kind == "SWITCH" else counts
        if any(bodies) and (kind in {"WHILE", "FOR", "MACRO"} or len(set(bodies)) > 1):
            self.unknown = True
        elif any(bodies):
            if self._bodies:
                self._bodies[-1][1][-1] += bodies[0]
            else:
                self.open += bodies[0]
