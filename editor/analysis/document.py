"""A text that is being edited."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterator
from functools import cached_property
from itertools import accumulate
from typing import Any, Final, TypeVar

from lark import Token
from minipov.editor.analysis.problem import Problem
from minipov.editor.analysis.statements import Statement, split, unchanged
from minipov.grammar.lexer import speaks_38

T = TypeVar("T")

_MOST_PARTS: Final = 50_000


class Document:
    """A text with its statements; ``edited`` gives the next one, which shares what did not change.

    ``found`` keeps what analyses found out about the whole text, ``parts`` what is known about parts of statements.
    """

    def __init__(self, text: str, path: str = "", before: Document | None = None) -> None:
        self.text = text
        self.path = path
        self.found: dict[str, Any] = {}
        self.parts: dict[bytes, list[Problem]] = before.parts if before and len(before.parts) < _MOST_PARTS else {}
        self.version_38 = speaks_38(text)
        self.statements = _statements(text, self.version_38, before)
        self.starts = list(accumulate((len(s.text) for s in self.statements[:-1]), initial=0))

    def known(self, name: str, work: Callable[[Document], T]) -> T:
        """What ``work`` finds out about the text, worked out once."""
        if name not in self.found:
            self.found[name] = work(self)
        return self.found[name]  # type: ignore[no-any-return]  # put in above

    def edited(self, text: str) -> Document:
        """The document after an edit."""
        return Document(text, self.path, self)

    def placed(self) -> Iterator[tuple[int, Statement]]:
        """All statements, each with its offset."""
        return zip(self.starts, self.statements, strict=False)

    def at(self, offset: int) -> tuple[int, Statement]:
        """The statement at an offset, and where it begins."""
        if not self.statements:
            return 0, Statement("", [], [])
        index = bisect_right(self.starts, offset) - 1
        return self.starts[index], self.statements[index]

    def token_at(self, offset: int) -> tuple[Token, int] | None:
        """The word at an offset (or that ends there), and the offset of its statement."""
        start, statement = self.at(offset)
        index = bisect_right(statement.tokens, offset - start, key=lambda token: token.start_pos or 0)
        for token in reversed(statement.tokens[max(0, index - 2) : index]):
            if (token.start_pos or 0) <= offset - start <= (token.end_pos or 0) and is_word(token):
                return token, start
        start_token = statement.tokens[index - 1] if index else None
        if start_token is not None and offset - start < (start_token.end_pos or 0):
            return start_token, start
        return None

    @cached_property
    def line_starts(self) -> list[int]:
        """The offset of each line."""
        return line_starts(self.text)

    def line_of(self, offset: int) -> int:
        """The line of an offset, from 0."""
        return bisect_right(self.line_starts, offset) - 1


def line_starts(text: str) -> list[int]:
    """The offset of each line of a text."""
    return list(accumulate((len(line) + 1 for line in text.split("\n")[:-1]), initial=0))


def is_word(token: Token) -> bool:
    """Whether a token is an identifier or a keyword."""
    return isinstance(token.value, str) and token.type != "STRING" and token.value[:1].isidentifier()


def _statements(text: str, version_38: bool, before: Document | None) -> list[Statement]:
    if before is None or before.version_38 != version_38:
        return list(split(text, 0, version_38))
    same_head = _common_prefix(before.text, text)
    same_tail = min(_common_suffix(before.text, text), min(len(text), len(before.text)) - same_head)
    # A statement ends where the next begins, so the last of those before the edit is looked at again.
    # Where one is guessed to end may depend on all that follows.
    kept = max(0, bisect_right(before.starts, same_head) - 2)
    kept = next((index for index, statement in enumerate(before.statements[:kept]) if statement.open), kept)
    statements = before.statements[:kept]
    at = before.starts[kept] if kept < len(before.starts) else 0
    shift = len(before.text) - len(text)
    old_starts = {start: index for index, start in enumerate(before.starts)}

    def known(start: int) -> list[Token]:
        index = old_starts.get(start)
        return [] if index is None or start >= same_head else unchanged(before.statements[index], same_head - start)

    for statement in split(text, at, version_38, known):
        index = old_starts.get(at + shift) if at >= len(text) - same_tail else None
        if index is not None:
            return statements + before.statements[index:]
        statements.append(statement)
        at += len(statement.text)
    return statements


def _common_prefix(a: str, b: str) -> int:
    low, high = 0, min(len(a), len(b))
    while low < high:
        middle = (low + high + 1) // 2
        if a[low:middle] == b[low:middle]:
            low = middle
        else:
            high = middle - 1
    return low


def _common_suffix(a: str, b: str) -> int:
    low, high = 0, min(len(a), len(b))
    while low < high:
        middle = (low + high + 1) // 2
        if a[len(a) - middle : len(a) - low] == b[len(b) - middle : len(b) - low]:
            low = middle
        else:
            high = middle - 1
    return low
