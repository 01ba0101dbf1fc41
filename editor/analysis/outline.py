"""The outline of a text, and what can be folded away."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from minipov.editor.analysis.document import Document
from minipov.editor.analysis.language import SCENE
from minipov.editor.analysis.names import NameKind, names_in
from minipov.editor.analysis.scanning import comments
from minipov.editor.analysis.statements import Statement
from minipov.grammar.keywords import DIVIDING, OPENING

_BODY_ENDS: Final = DIVIDING | {"END"}
_BRACE_ENDS: Final = frozenset({"RBRACE", "LOOSE_RBRACE"})


@dataclass(frozen=True, slots=True)
class Entry:
    """A declaration, or a block that stands by itself (``kind`` ``block``); the name stands at ``start`` to ``end``."""

    name: str
    kind: NameKind | str
    detail: str
    start: int
    end: int
    from_: int
    to: int

    def moved(self, by: int) -> Entry:
        """The same entry further down the text."""
        return Entry(self.name, self.kind, self.detail, self.start + by, self.end + by, self.from_ + by, self.to + by)


def outline(document: Document) -> list[Entry]:
    """The declarations and scene items of a text, from top to bottom."""
    found = []
    for start, statement in document.placed():
        declared = [
            d for d in names_in(statement).declared if d.scope is None and d.kind not in {"counter", "parameter"}
        ]
        for one in declared:
            detail = f"({', '.join(one.parameters)})" if one.parameters else one.value
            found.append(
                Entry(one.name, one.kind, detail, one.start + start, one.end + start, one.from_ + start, one.to + start)
            )
        found += [entry.moved(start) for entry in statement.known("blocks", lambda statement: list(_blocks(statement)))]
    return sorted(found, key=lambda entry: entry.from_)


def _blocks(statement: Statement) -> Iterator[Entry]:
    """Blocks that stand by themselves, not the value of a declaration."""
    depth, open_block, previous = 0, None, None
    for token in statement.tokens:
        kind = token.type
        if kind in OPENING:
            depth += 1
        elif kind == "END":
            depth -= 1
        elif kind in {"LBRACE", "LOOSE_LBRACE"}:
            if depth == 0 and open_block is None and previous is not None and str(previous.value) in SCENE:
                open_block = previous
            depth += 1
        elif kind in {"RBRACE", "LOOSE_RBRACE"}:
            depth -= 1
            if depth <= 0 and open_block is not None:
                begin, end = open_block.start_pos or 0, open_block.end_pos or 0
                yield Entry(str(open_block.value), "block", "", begin, end, begin, token.end_pos or 0)
                open_block = None
        elif kind in {"DECLARE", "LOCAL"}:
            return
        previous = token


def folds(document: Document) -> list[tuple[int, int, bool]]:
    """First and last line, from 0, of blocks, directive bodies and comments; the last tells whether it is a comment."""
    found: list[tuple[int, int, bool]] = []
    for start, statement in document.placed():
        line = document.line_of(start)
        found += [
            (first + line, last + line, comment) for first, last, comment in statement.known("folds", _sorted_folds)
        ]
    return found


def _sorted_folds(statement: Statement) -> list[tuple[int, int, bool]]:
    return sorted(_folds(statement))


def _folds(statement: Statement) -> Iterator[tuple[int, int, bool]]:
    opened: list[tuple[str, int]] = []
    for token in statement.tokens:
        kind, line = token.type, (token.line or 1) - 1
        if kind in OPENING or kind in {"LBRACE", "LOOSE_LBRACE"}:
            opened.append((kind, line))
        elif opened and kind in (_BODY_ENDS if opened[-1][0] in OPENING | DIVIDING else _BRACE_ENDS):
            first = opened.pop()[1]
            if line - 1 > first:
                yield first, line - 1, False
            if kind in DIVIDING:
                opened.append((kind, line))
    at = 0
    for token in statement.tokens:
        if (token.start_pos or 0) > at + 1:
            yield from _comment_folds(statement.text, at, token.start_pos or 0)
        at = token.end_pos or 0
    yield from _comment_folds(statement.text, at, len(statement.text))


def _comment_folds(text: str, start: int, end: int) -> Iterator[tuple[int, int, bool]]:
    for begin, stop in comments(text, start, end):
        lines = text.count("\n", begin, stop)
        if lines:
            first = text.count("\n", 0, begin)
            yield first, first + lines, True
