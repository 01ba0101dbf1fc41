"""Where in the language an offset is: in a comment, in the name of an include, in a block, in a call."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, TypeAlias

from lark import Token
from minipov.editor.analysis.document import Document
from minipov.editor.analysis.scanning import comments
from minipov.editor.analysis.surroundings import Opening, open_after, path

Situation: TypeAlias = Literal["comment", "include", "string", "directive", "member", "name", "value", "item"]
"""``name``: one is being made; ``value``: inside a vector, a call or an expression; ``item``: where items stand."""

_OPERATORS = frozenset({"PLUS", "MINUS", "STAR", "SLASH", "EQUAL", "QUESTION", "BANG", "AND", "OR", "LESSEQ", "MOREEQ",
                        "NOTEQ", "RGB"})  # fmt: skip
_NAMING = frozenset({"DECLARE", "LOCAL", "MACRO"})


@dataclass(frozen=True, slots=True)
class Context:
    """``typed`` is what stands before the offset of the word or file name there, which begins at ``start``."""

    situation: Situation
    start: int
    typed: str = ""
    blocks: tuple[str, ...] = ()
    before: tuple[Token, ...] = ()
    openings: tuple[Opening, ...] = ()


def context_at(document: Document, offset: int) -> Context:
    """What an editor needs to know to go on typing at an offset."""
    start, statement = document.at(offset)
    local = offset - start
    tokens = [token for token in statement.tokens if (token.start_pos or 0) < local]
    last = tokens[-1] if tokens else None
    if last is not None and last.type == "STRING" and local < (last.end_pos or 0):
        return _in_string(document, tokens[:-1], start + (last.start_pos or 0) + 1, offset)
    begin = last.end_pos or 0 if last is not None else 0
    gap_end = next((t.start_pos or 0 for t in statement.tokens if (t.start_pos or 0) >= local), len(statement.text))
    for comment_start, comment_end in comments(statement.text, begin, gap_end):
        if comment_start < local and (local < comment_end or _is_line(statement.text, comment_start, local)):
            return Context("comment", offset)
    line = document.text.rfind("\n", 0, offset) + 1
    opened = document.text.find('"', max(line, start + begin), offset)
    if opened >= 0:
        return _in_string(document, tokens, opened + 1, offset)
    if document.text[max(line, start + begin) : offset].lstrip().startswith("#"):
        return Context("directive", document.text.rindex("#", 0, offset) + 1, document.text[offset:offset])
    return _among_tokens(document, tokens, start, offset)


def _is_line(text: str, comment_start: int, offset: int) -> bool:
    return text.startswith("//", comment_start) and "\n" not in text[comment_start:offset]


def _in_string(document: Document, before: Sequence[Token], start: int, offset: int) -> Context:
    is_include = bool(before) and before[-1].type == "INCLUDE"
    return Context("include" if is_include else "string", start, document.text[start:offset])


def _among_tokens(document: Document, tokens: list[Token], start: int, offset: int) -> Context:
    last = tokens[-1] if tokens else None
    begin = offset
    if last is not None and start + (last.end_pos or 0) >= offset and str(last.value)[:1] in "#":
        return Context("directive", start + (last.start_pos or 0) + 1)
    if last is not None and start + (last.end_pos or 0) >= offset and str(last.value)[:1].isidentifier():
        begin = start + (last.start_pos or 0)
        tokens = tokens[:-1]
    typed = document.text[begin:offset]
    stack = open_after(tokens)
    previous = tokens[-1].type if tokens else ""
    situation: Situation = "item"
    if previous == "DOT":
        situation = "member"
    elif previous in _NAMING:
        situation = "name"
    elif previous in _OPERATORS or (stack and stack[-1].mark in {"(", "<"}) or (stack and stack[-1].name == "function"):
        situation = "value"
    return Context(situation, begin, typed, path(stack), tuple(tokens), tuple(stack))


@dataclass(frozen=True, slots=True)
class Call:
    """A call whose parentheses are open at an offset; ``argument`` counts from 0."""

    name: str
    start: int
    argument: int


def call_at(document: Document, offset: int) -> Call | None:
    """The innermost call around an offset."""
    start, statement = document.at(offset)
    tokens = [token for token in statement.tokens if (token.start_pos or 0) < offset - start]
    stack = open_after(tokens)
    inner: list[str] = []
    for opening in reversed(stack):
        if opening.mark == "(" and opening.name and tokens[opening.index - 1].type != "WORD":
            argument = _commas(tokens, opening.index)
            return Call(opening.name, start + (tokens[opening.index - 1].start_pos or 0), argument)
        if opening.mark not in {"<", "(", "["}:
            return None
        inner.append(opening.mark)
    return None


def _commas(tokens: Sequence[Token], opened: int) -> int:
    """The commas behind the bracket at ``opened`` that are not in inner brackets."""
    count, depth = 0, 0
    for token in tokens[opened + 1 :]:
        if token.type in {"LPAR", "LOOSE_LPAR", "LESS", "LSQB", "LBRACE"}:
            depth += 1
        elif token.type in {"RPAR", "MORE", "RSQB", "RBRACE"}:
            depth -= 1
        elif token.type == "COMMA" and depth == 0:
            count += 1
    return count
