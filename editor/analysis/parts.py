"""Large statements checked in parts, so that an edit in a mesh or a guarded include costs only what is around it.

A block ``WORD { ... }`` and the body of a directive hold items of their own, whatever is around them. Each large one is
parsed by itself, and known again by its text; what is around it is parsed without it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, MutableMapping, Sequence
from dataclasses import dataclass, field
from hashlib import blake2b
from typing import Final, TypeAlias

from lark import Token
from minipov.editor.analysis.problem import Problem
from minipov.editor.analysis.recovery import parse_tokens
from minipov.editor.analysis.statements import Statement
from minipov.grammar.keywords import DIVIDING, OPENING

LARGE: Final = 1000
"""Tokens from which on a statement is checked in parts."""

_SMALLEST: Final = 12
"""Tokens below which a block or body is parsed with what is around it."""

_SHORTEST_RUN: Final = 100
_LOOKED_AT: Final = 6
_OPENS: Final = OPENING | {"LBRACE", "LPAR", "LSQB", "LESS"}
_CLOSES: Final = frozenset({"END", "RBRACE", "RPAR", "RSQB", "MORE"})

Known: TypeAlias = MutableMapping[bytes, list[Problem]]
"""Problems by the digest of a part's text, at offsets from its start."""


@dataclass(slots=True)
class _Part:
    """The tokens ``first`` up to ``end`` (not included); with the braces around it, if ``braces``."""

    first: int
    end: int = 0
    braces: bool = False
    inner: list[_Part] = field(default_factory=list)


def problems_by_parts(statement: Statement, known: Known) -> list[Problem]:
    """What is wrong in a large statement; ``known`` is read and added to."""
    tokens = statement.marked()
    whole = _Part(0, len(tokens), inner=_parts(tokens))
    return sorted(_check(whole, statement, known), key=lambda problem: problem.start)


def _check(part: _Part, statement: Statement, known: Known) -> Iterable[Problem]:
    tokens = statement.tokens
    if part.first >= part.end:
        return ()
    start = tokens[part.first].start_pos or 0
    key = _digest(statement.text[start : tokens[part.end - 1].end_pos])
    if key not in known:
        found: list[Problem] = []
        for run in _runs(list(_around(part, tokens)), statement.text):
            found += _check_run(run, statement, known)
        for inner in part.inner:
            found += _check(inner, statement, known)
        known[key] = [problem.moved(-start) for problem in found]
    return [problem.moved(start) for problem in known[key]]


def _check_run(run: Sequence[Token], statement: Statement, known: Known) -> Iterable[Problem]:
    start = run[0].start_pos or 0
    key = _digest(statement.text[start : run[-1].end_pos])
    if key not in known:
        known[key] = [problem.moved(-start) for problem in parse_tokens(run, run[-1], statement)[1]]
    return [problem.moved(start) for problem in known[key]]


def _runs(tokens: list[Token], text: str) -> Iterator[list[Token]]:
    """The items of a part in runs that end at a comma outside of all brackets, for long lists of numbers and vectors.

    Whether one ends at a comma is decided by what stands there, so that an edit does not move the ends of all others.
    """
    first = depth = 0
    for at, token in enumerate(tokens):
        kind = token.type
        if kind in _OPENS:
            depth += 1
        elif kind in _CLOSES:
            depth -= 1
        elif kind == "COMMA" and depth == 0 and at - first >= _SHORTEST_RUN:
            comma = token.start_pos or 0
            if hash(text[comma - _LOOKED_AT : comma]) % 4 == 0:
                yield tokens[first : at + 1]
                first = at + 1
    if first < len(tokens):
        yield tokens[first:]


def _digest(text: str) -> bytes:
    return blake2b(text.encode("utf-8", "surrogatepass"), digest_size=16).digest()


def _around(part: _Part, tokens: Sequence[Token]) -> Iterator[Token]:
    """The tokens of a part without those of its inner parts."""
    at = part.first
    for inner in part.inner:
        margin = 1 if inner.braces else 0
        yield from tokens[at : inner.first - margin]
        at = inner.end + margin
    yield from tokens[at : part.end]


def _parts(tokens: Sequence[Token]) -> list[_Part]:
    """The outermost parts of a statement, each with those inside it."""
    outermost: list[_Part] = []
    stack: list[tuple[str, _Part | None]] = []
    levels = [outermost]

    def open_(kind: str, part: _Part | None) -> None:
        stack.append((kind, part))
        if part is not None:
            levels.append(part.inner)

    def close(end: int) -> None:
        _, part = stack.pop()
        if part is None:
            return
        inner = levels.pop()
        part.end = end
        if end - part.first >= _SMALLEST:
            levels[-1].append(part)
        else:
            levels[-1].extend(inner)

    at = 0
    while at < len(tokens):
        kind = tokens[at].type
        in_function = any(opened == "function" for opened, _ in stack)
        if kind == "LBRACE":
            before = tokens[at - 1].type if at else ""
            if before == "WORD" and not in_function:
                open_("{", _Part(at + 1, braces=True))
            else:
                open_("function" if before in {"FUNCTION_WORD", "RPAR"} or in_function else "{", None)
        elif kind == "RBRACE" and stack:
            close(at)
        elif kind in OPENING or kind in DIVIDING:
            if kind in DIVIDING and stack:
                close(at)
            at = _head_end(tokens, at)
            open_(kind, None if kind == "SWITCH" else _Part(at + 1))
        elif kind == "END" and stack:
            close(at)
        at += 1
    return outermost


def _head_end(tokens: Sequence[Token], at: int) -> int:
    """The last token of a directive's head: the parenthesis that closes its condition or parameters."""
    if tokens[at].type == "ELSE":
        return at
    depth = 0
    for index in range(at + 1, len(tokens)):
        kind = tokens[index].type
        if kind == "LPAR":
            depth += 1
        elif kind == "RPAR":
            depth -= 1
            if depth == 0:
                return index
        elif depth == 0 and kind != "NAME":
            return index - 1
    return at
