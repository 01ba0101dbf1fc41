"""Braces whose partner lies in another directive body: ``#if (M) merge { #else union { #end ... }``.

Inside each body of a directive braces are matched; what stays unmatched becomes LOOSE_LBRACE or LOOSE_RBRACE, so that the
tree nests everywhere else.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from lark import Token

_OPENING: Final = frozenset({"IF", "IFDEF", "IFNDEF", "SWITCH", "WHILE", "FOR", "MACRO"})
_DIVIDING: Final = frozenset({"ELSE", "ELSEIF", "CASE", "RANGE"})


def mark_loose_braces(tokens: Sequence[Token]) -> Sequence[Token]:
    """The same tokens, with the type of unmatched braces changed in place."""
    open_braces: list[Token | None] = []  # None marks where a directive's body begins

    def close_body() -> None:
        while open_braces and (brace := open_braces.pop()) is not None:
            brace.type = "LOOSE_LBRACE"

    for token in tokens:
        kind = token.type
        if kind == "LBRACE":
            open_braces.append(token)
        elif kind == "RBRACE":
            if open_braces and open_braces[-1] is not None:
                open_braces.pop()
            else:
                token.type = "LOOSE_RBRACE"
        elif kind in _OPENING:
            open_braces.append(None)
        elif kind in _DIVIDING:
            close_body()
            open_braces.append(None)
        elif kind == "END":
            close_body()
    for brace in open_braces:
        if brace is not None:
            brace.type = "LOOSE_LBRACE"
    return tokens
