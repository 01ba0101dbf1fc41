"""Tokens of a text that may be half written: what cannot be read becomes a problem, and reading goes on behind it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Final

from lark import Token
from minipov.editor.analysis.problem import Problem
from minipov.grammar.comments import comment_end
from minipov.grammar.errors import SdlSyntaxError
from minipov.grammar.lexer import tokenize

_UNREADABLE: Final = re.compile(r"/\*.*|\"[^\n]*|#[ \t\r\n]*\w+|[\w.]+|.", re.DOTALL)
_BLANKS_OR_COMMENT: Final = re.compile(r"[^\S\n]*(?://[^\n]*)?")
_SPACE: Final = re.compile(r"\s*")


def scan(text: str, start: int, at: int, version_38: bool, problems: list[Problem]) -> Iterator[Token]:
    """Tokens from ``at`` on; offsets, lines and columns count from ``start``, which begins a line."""
    while True:
        lines = text.count("\n", start, at)
        column_shift = at - max(start, text.rfind("\n", start, at) + 1)
        try:
            for token in tokenize(text, "", at, version_38):
                if token.line == 1:
                    token.column = (token.column or 0) + column_shift
                token.line = (token.line or 0) + lines
                token.start_pos = (token.start_pos or 0) - start
                token.end_pos = (token.end_pos or 0) - start
                yield token
            return
        except SdlSyntaxError as error:
            begin = _offset(text, at, error.line, error.column)
            unreadable = _UNREADABLE.match(text, begin)
            end = unreadable.end() if unreadable else begin + 1
            problems.append(Problem(begin - start, end - start, error.message, error.hint))
            at = end


def _offset(text: str, start: int, line: int, column: int) -> int:
    """The offset of a place whose line and column count from ``start``."""
    for _ in range(line - 1):
        start = text.index("\n", start) + 1
    return start + column - 1


def comments(text: str, start: int, end: int) -> Iterator[tuple[int, int]]:
    """The comments between two tokens."""
    while True:
        start = _SPACE.match(text, start, end).end()  # type: ignore[union-attr]  # matches everywhere
        if text.startswith("//", start, end):
            stop = text.find("\n", start, end)
            stop = end if stop < 0 else stop
        elif text.startswith("/*", start, end):
            stop = min(comment_end(text, start) or end, end)
        else:
            return
        yield start, stop
        start = stop


def line_break(text: str, start: int, end: int) -> int | None:
    """The start of the first line that begins between two tokens and not within a comment, or None."""
    while True:
        start = _BLANKS_OR_COMMENT.match(text, start, end).end()  # type: ignore[union-attr]  # matches everywhere
        if text.startswith("\n", start, end):
            return start + 1
        if not text.startswith("/*", start, end):
            return None
        start = comment_end(text, start) or len(text)
