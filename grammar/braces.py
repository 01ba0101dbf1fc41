"""Braces whose partner lies in another directive body: ``#if (M) merge { #else union { #end ... }``.

Inside each body of a directive braces are matched; what stays unmatched becomes LOOSE_LBRACE or LOOSE_RBRACE, so
that the tree nests everywhere else. The parenthesis of ``#write (`` may be loose in the same way.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from lark import Token

_OPENING: Final = frozenset({"IF", "IFDEF", "IFNDEF", "SWITCH", "WHILE", "FOR", "MACRO"})
_DIVIDING: Final = frozenset({"ELSE", "ELSEIF", "CASE", "RANGE"})


def mark_loose_braces(tokens: Sequence[Token]) -> Sequence[Token]:
    """The same tokens, with the type of unmatched braces and parentheses changed in place."""
    open_marks: list[Token | None] = []  # None marks where a directive's body begins

    def close_body() -> None:
        while open_marks and (mark := open_marks.pop()) is not None:
            mark.type = "LOOSE_" + mark.type

    def close(token: Token, opening: str) -> None:
        for at in range(len(open_marks) - 1, -1, -1):
            mark = open_marks[at]
            if mark is None:
                break
            if mark.type == opening:
                del open_marks[at:]
                return
        token.type = "LOOSE_" + token.type

    for token in tokens:
        kind = token.type
        if kind in {"LBRACE", "LPAR"}:
            open_marks.append(token)
        elif kind == "RBRACE":
            close(token, "LBRACE")
        elif kind == "RPAR":
            close(token, "LPAR")
        elif kind in _OPENING:
            open_marks.append(None)
        elif kind in _DIVIDING:
            close_body()
            open_marks.append(None)
        elif kind == "END":
            close_body()
    while open_marks:
        close_body()
    return tokens
