"""What is open around each token: blocks by name, calls, brackets, vectors."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

from lark import Token
from minipov.grammar.keywords import OPENING

_CLOSES: Final = {"RBRACE": "{", "LOOSE_RBRACE": "{", "RPAR": "(", "LOOSE_RPAR": "(", "RSQB": "[", "MORE": "<"}
_BRACES: Final = frozenset({"LBRACE", "LOOSE_LBRACE"})
_OPERANDS: Final = frozenset({"NUMBER", "NAME", "RPAR", "MORE", "CONSTANT", "RSQB", "STRING"})


@dataclass(frozen=True, slots=True)
class Opening:
    """A bracket that is open; ``name`` is the word before it, ``index`` that of its token."""

    mark: str
    name: str
    index: int


def surroundings(tokens: Sequence[Token]) -> Iterator[tuple[Token, list[Opening]]]:
    """Each token with what is open before it, the outermost first. The list is used again for the next token.

    A directive is an opening too: ``#``, named ``MACRO``, ``IF`` and so on.
    """
    stack: list[Opening] = []
    previous: Token | None = None
    for index, token in enumerate(tokens):
        yield token, stack
        kind = token.type
        name = _name(previous)
        if kind in OPENING:
            stack.append(Opening("#", kind, index))
        elif kind == "END":
            _close(stack, "#")
        elif kind in _BRACES:
            stack.append(Opening("{", name, index))
        elif kind in {"LPAR", "LOOSE_LPAR"}:
            stack.append(Opening("(", name, index))
        elif kind == "LSQB":
            stack.append(Opening("[", name if previous is not None and previous.type == "NAME" else "", index))
        elif kind == "LESS" and not _compares(stack, previous):
            stack.append(Opening("<", "", index))
        elif kind in _CLOSES and (kind != "MORE" or (stack and stack[-1].mark == "<")):
            _close(stack, _CLOSES[kind])
        previous = token


def open_after(tokens: Sequence[Token]) -> list[Opening]:
    """What is open behind the last token."""
    *_, (_, stack) = surroundings([*tokens, Token("NAME", "")])
    return list(stack)


def path(stack: Sequence[Opening]) -> tuple[str, ...]:
    """The names of the open blocks and map entries, the outermost first."""
    return tuple(
        opening.name if opening.mark == "{" else "["
        for opening in stack
        if opening.mark == "{" or (opening.mark == "[" and not opening.name)
    )


def _name(token: Token | None) -> str:
    if token is None:
        return ""
    if token.type in {"DEFAULT", "DEFAULT_WORD"}:
        return "#default"
    if token.type in {"WORD", "NAME", "FUNCTION", "UNARY_FUNCTION", "FUNCTION_WORD", "CONSTANT"}:
        return str(token.value)
    return ""


def _close(stack: list[Opening], mark: str) -> None:
    for at in range(len(stack) - 1, -1, -1):
        if stack[at].mark == mark:
            del stack[at:]
            return
        if stack[at].mark == "#":
            return


def _compares(stack: Sequence[Opening], previous: Token | None) -> bool:
    around = next((opening.mark for opening in reversed(stack) if opening.mark != "<"), "")
    return around == "(" and previous is not None and previous.type in _OPERANDS
