"""A text cut into statements, so that an edit costs only the statements that it touches.

A statement is a run of whole lines outside of which no bracket and no directive is open. All that is worked out about
one is relative to its start and stays with it while other parts of the text change.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from itertools import chain, pairwise
from typing import Any, Final, TypeAlias, TypeVar

from lark import Token
from minipov.editor.analysis.language import BLOCKS
from minipov.editor.analysis.problem import Problem
from minipov.editor.analysis.scanning import line_break, scan
from minipov.grammar.braces import mark_loose_braces
from minipov.grammar.function_bodies import mark_function_bodies
from minipov.grammar.keywords import DIRECTIVE_TOKENS, DIVIDING, OPENING
from minipov.grammar.lexer import PUNCTUATION

T = TypeVar("T")

Reuse: TypeAlias = Callable[[int], list[Token]]
"""The tokens that are known of the statement at an offset, from before an edit."""

STARTING: Final = DIRECTIVE_TOKENS - DIVIDING - {"END"}
"""Directives that may open a statement."""

BRACKETS: Final = {"{": "}", "(": ")", "[": "]", "<": ">"}
_ENDS: Final = frozenset({"RBRACE", "SEMICOLON", "END", "STRING", "RPAR"})
_OPERAND_ENDS: Final = _ENDS | {"NUMBER", "NAME", "MORE", "CONSTANT", "RSQB"}


@dataclass(slots=True, eq=False)
class Statement:
    """Whole lines of a text; offsets, lines and columns of its tokens count from its start.

    ``open`` says that something in it is never closed, so that its end was guessed from all that follows. ``found``
    keeps what analyses found out about it, by the name of the analysis.
    """

    text: str
    tokens: list[Token]
    problems: list[Problem]
    open: bool = False
    found: dict[str, Any] = field(default_factory=dict)

    def marked(self) -> list[Token]:
        """The tokens, with braces marked that have no partner; an edit may have left marks of another state."""
        for token in self.tokens:
            token.type = _unmarked(token)
        mark_loose_braces(self.tokens)
        return list(mark_function_bodies(self.tokens, self.text))

    def known(self, name: str, work: Callable[[Statement], T]) -> T:
        """What ``work`` finds out about the statement, worked out once."""
        if name not in self.found:
            self.found[name] = work(self)
        return self.found[name]  # type: ignore[no-any-return]  # put in above


class _Openings:
    """What is open at a token: brackets and directives, the outermost first."""

    def __init__(self) -> None:
        self.stack: list[tuple[str, Token]] = []
        self.previous = ""

    def take(self, token: Token) -> None:
        kind, value = token.type, token.value
        if kind in OPENING:
            self.stack.append(("#", token))
        elif kind == "END":
            self._close("#")
        elif kind in DIVIDING:
            self._close_body()
        elif kind in {"LBRACE", "LPAR", "LSQB"}:
            self.stack.append((value, token))
        elif kind == "LESS":
            if self._opens_vector():
                self.stack.append((value, token))
        elif kind in {"RBRACE", "RPAR", "RSQB", "MORE"}:
            self._close({"}": "{", ")": "(", "]": "[", ">": "<"}[value])
        elif kind == "SEMICOLON" and self.stack and self.stack[-1][0] == "<":
            self.stack.pop()
        self.previous = kind

    def _opens_vector(self) -> bool:
        """Whether a ``<`` opens a vector: outside parentheses always, inside where no operand stands before it."""
        around = next((mark for mark, _ in reversed(self.stack) if mark != "<"), "")
        return self.previous not in _OPERAND_ENDS or around != "("

    def _close(self, mark: str) -> None:
        """Close the innermost ``mark``, with what is left open in it; a bracket does not reach out of its directive."""
        for at in range(len(self.stack) - 1, -1, -1):
            if self.stack[at][0] == mark:
                del self.stack[at:]
                return
            if self.stack[at][0] == "#" or mark == "<":
                return

    def _close_body(self) -> None:
        while self.stack and self.stack[-1][0] != "#":
            self.stack.pop()


def _may_start(token: Token, previous: str) -> bool:
    """Whether a statement may begin at ``token``, where nothing is open."""
    kind = token.type
    if kind in STARTING:
        return previous in _OPERAND_ENDS
    if previous in _ENDS:
        return kind == "NAME" or _names_block(token)
    return previous in _OPERAND_ENDS and _names_block(token)


def _names_block(token: Token) -> bool:
    """Whether a token is a word that begins blocks; a run of literal vectors is worth its numbers."""
    return token.type != "BULK" and token.value in BLOCKS


def split(text: str, start: int, version_38: bool, before: Reuse | None = None) -> Iterator[Statement]:
    """The statements of ``text`` from ``start`` on, where one must begin."""
    while start < len(text):
        statement = _next(text, start, version_38, before(start) if before else [])
        yield statement
        start += len(statement.text)


def _next(text: str, start: int, version_38: bool, known: list[Token]) -> Statement:
    """The statement at ``start``, of whose tokens the first are ``known``."""
    openings = _Openings()
    problems: list[Problem] = []
    tokens: list[Token] = []
    previous_end, end = 0, len(text) - start
    at = start + (known[-1].end_pos or 0) if known else start
    for token in chain(known, scan(text, start, at, version_38, problems)):
        if tokens and not openings.stack and _may_start(token, openings.previous):
            line = line_break(text, start + previous_end, start + (token.start_pos or 0))
            if line is not None:
                end = line - start
                break
        openings.take(token)
        tokens.append(token)
        previous_end = token.end_pos or 0
    if openings.stack:
        end = _end_after(text, start, tokens, openings.stack[0][1], end)
        tokens = [token for token in tokens if (token.start_pos or 0) < end]
    problems = [problem for problem in problems if problem.start < end]
    return Statement(text[start : start + end], tokens, problems, bool(openings.stack or problems))


def _end_after(text: str, start: int, tokens: list[Token], opener: Token, end: int) -> int:
    """Where to end a statement in which ``opener`` is never closed: at the next line that looks like another one."""
    after = False
    for previous, token in pairwise(tokens):
        after = after or previous is opener
        begins_line = token.column == 1 and token.line != previous.line
        if after and begins_line and (token.type in STARTING or _names_block(token)):
            line = line_break(text, start + (previous.end_pos or 0), start + (token.start_pos or 0))
            if line is not None:
                return line - start
    return end


def unchanged(statement: Statement, length: int) -> list[Token]:
    """The tokens of a statement that stay as they are when only what lies behind its first characters changes.

    The last of them may grow, so it is not counted. What is loose must be found out again.
    """
    length = min([length, *(problem.start for problem in statement.problems)])
    count = bisect_left(statement.tokens, length, key=lambda token: token.end_pos or 0)
    return [
        Token.new_borrow_pos(_unmarked(token), token.value, token) if token.type.startswith("LOOSE_") else token
        for token in statement.tokens[: max(0, count - 1)]
    ]


def _unmarked(token: Token) -> str:
    """The type that a token has by itself."""
    return PUNCTUATION[token.value] if token.type.startswith("LOOSE_") else token.type
