"""What is torn apart by directives: ``#if (M) merge { #else union { #end ... }``, ``(2 * #if (A) 3 #else 4 #end)``.

Inside each body of a directive braces are matched; what stays unmatched becomes LOOSE_LBRACE or LOOSE_RBRACE, so
that the tree nests everywhere else. The parenthesis of ``#write (`` may be loose in the same way. An operator whose
operand lies behind the edge of a body becomes LOOSE_OPERATOR.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from lark import Token
from minipov.grammar.keywords import DIRECTIVE_TOKENS, DIVIDING, OPENING

_HEADED: Final = (OPENING | DIVIDING) - {"ELSE", "MACRO"}
_OPERATORS: Final = frozenset({"PLUS", "MINUS", "STAR", "SLASH", "BANG"})
_BODY_EDGES: Final = frozenset({"ELSE", "END", "HEAD_END"})


def mark_loose_braces(tokens: Sequence[Token]) -> Sequence[Token]:
    """The same tokens, with the type of unmatched braces and parentheses changed in place."""
    open_marks: list[Token | None] = []  # None marks where a directive's body begins

    def close_body() -> None:
        while open_marks and (mark := open_marks.pop()) is not None:
            mark.type = "LOOSE_" + mark.type

    def close(token: Token, opening: str) -> Token | None:
        for at in range(len(open_marks) - 1, -1, -1):
            mark = open_marks[at]
            if mark is None:
                break
            if mark.type == opening:
                del open_marks[at:]
                return mark
        token.type = "LOOSE_" + token.type
        return None

    previous, before = "", None
    heads: list[Token] = []
    for token in tokens:
        kind = token.type
        if before is not None and kind in DIRECTIVE_TOKENS and before.type in _OPERATORS:
            before.type = "LOOSE_OPERATOR"
        elif kind in {"STAR", "SLASH"} and previous in _BODY_EDGES:
            token.type = "LOOSE_OPERATOR"
        if kind == "LPAR" and previous in _HEADED:
            heads.append(token)
        before, previous = token, kind
        if kind in {"LBRACE", "LPAR"}:
            open_marks.append(token)
        elif kind == "RBRACE":
            close(token, "LBRACE")
        elif kind == "RPAR":
            opening = close(token, "LPAR")
            if heads and opening is heads[-1]:
                heads.pop()
                previous = "HEAD_END"
        elif kind in OPENING:
            open_marks.append(None)
        elif kind in DIVIDING:
            close_body()
            open_marks.append(None)
        elif kind == "END":
            close_body()
    while open_marks:
        close_body()
    return tokens
