"""Colours that are written as literals: ``rgb <1, 0.5, 0>``, ``srgb 0.2``."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

from lark import Token
from minipov.editor.analysis.document import Document
from minipov.editor.analysis.statements import Statement

_LARGEST_LITERAL: Final = 14
_SIGNS: Final = {"PLUS": 1.0, "MINUS": -1.0}


@dataclass(frozen=True, slots=True)
class ColorLiteral:
    """The terms of a colour at the offsets ``start`` to ``end``, behind the keyword ``word``; ``shown`` is in sRGB."""

    start: int
    end: int
    word: str
    terms: tuple[float, ...]
    shown: tuple[float, float, float]


def color_literals(document: Document) -> Iterator[ColorLiteral]:
    """All colour literals of a text, from top to bottom."""
    linear = is_linear(document)
    for start, statement in document.placed():
        for begin, end, word, terms in statement.known("colors", lambda statement: list(_literals(statement))):
            red, green, blue = (terms if len(terms) > 1 else terms * 3)[:3]
            encode = linear and not word.startswith("s")
            shown = tuple(max(0.0, min(1.0, _to_srgb(c) if encode else c)) for c in (red, green, blue))
            yield ColorLiteral(start + begin, start + end, word, terms, (shown[0], shown[1], shown[2]))


def written(literal: ColorLiteral, document: Document, shown: tuple[float, float, float]) -> str:
    """SDL for the terms of a literal after another colour was chosen; filter and transmit stay."""
    decode = is_linear(document) and not literal.word.startswith("s")
    terms = [_from_srgb(c) if decode else c for c in shown]
    return "<" + ", ".join(f"{round(term, 4):g}" for term in (*terms, *literal.terms[3:])) + ">"


def is_linear(document: Document) -> bool:
    """Whether ``rgb`` means linear light: ``assumed_gamma 1``, or none said in a scene of version 3.7 and later."""
    version = 0.0
    for statement in document.statements:
        for word, value in statement.known("gamma", _gamma_words):
            if word == "assumed_gamma":
                return value == 1.0
            version = version or value
    return version >= 3.7


def _gamma_words(statement: Statement) -> list[tuple[str, float]]:
    """What a statement says about ``assumed_gamma`` and ``version``: the number behind the word; srgb counts as 2.2."""
    found = []
    for token, value in pairwise(statement.tokens):
        number = float(value.value) if value.type == "NUMBER" else 2.2
        if token.type == "VERSION":
            found.append(("version", number))
        elif token.value == "assumed_gamma" and token.type == "WORD":
            found.append(("assumed_gamma", number))
    return found


def _literals(statement: Statement) -> Iterator[tuple[int, int, str, tuple[float, ...]]]:
    tokens = statement.tokens
    for at, token in enumerate(tokens):
        if token.type == "RGB" and at + 1 < len(tokens):
            end, terms = _terms(tokens, at + 1)
            if terms:
                yield tokens[at + 1].start_pos or 0, tokens[end].end_pos or 0, str(token.value), terms


def _terms(tokens: Sequence[Token], at: int) -> tuple[int, tuple[float, ...]]:
    """The numbers of a vector literal (or one number) that begins at ``at``, with the index of its last token."""
    if tokens[at].type == "NUMBER":
        ends = at + 1 == len(tokens) or tokens[at + 1].type not in {"STAR", "SLASH", "PLUS", "MINUS"}
        return at, (float(tokens[at].value),) if ends else ()
    if tokens[at].type != "LESS":
        return at, ()
    terms: list[float] = []
    sign, wants = 1.0, True
    for index in range(at + 1, min(len(tokens), at + _LARGEST_LITERAL)):
        token = tokens[index]
        if token.type == "NUMBER" and wants:
            terms.append(sign * float(token.value))
            sign, wants = 1.0, False
        elif token.type in _SIGNS and wants:
            sign *= _SIGNS[token.type]
        elif token.type == "COMMA" and not wants:
            wants = True
        elif token.type == "MORE" and not wants and len(terms) >= 3:
            return index, tuple(terms)
        else:
            break
    return at, ()


def _to_srgb(value: float) -> float:
    """Linear light in the encoding of IEC 61966-2-1."""
    return 12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055


def _from_srgb(value: float) -> float:
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4
