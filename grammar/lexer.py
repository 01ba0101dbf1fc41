"""Text to tokens.

Tokens are Lark tokens whose type is a terminal of sdl.lark. Comments (nestable), blanks and the byte order mark
vanish. A keyword gets its terminal from THE table; ``#word`` is one token, blanks after ``#`` or not.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches
from typing import Any, Final

import numpy as np
from lark import Token
from lark.lexer import Lexer
from minipov.grammar.comments import comment_end
from minipov.grammar.errors import SdlSyntaxError
from minipov.grammar.keywords import DIRECTIVES, KEYWORDS, Kind
from minipov.grammar.statements import find_run

_NUMBER = r"(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_SIGNED = rf"[+-]?{_NUMBER}"
_BULK_VECTOR = rf"<\s*+{_SIGNED}(?:\s*+,\s*+{_SIGNED}){{1,4}}\s*+>"

_TOKEN: Final = re.compile(
    rf"""
    (?P<skip>[\s\ufeff\x1a\0]+|//[^\n]*|\#(?![ \t\r\n]*[A-Za-z_]))
  | (?P<comment>/\*)
  | (?P<hole>\x01)
  | (?P<fault>\x02)
  | (?P<word>[A-Za-z_][A-Za-z0-9_]*)
  | (?P<number>{_NUMBER})
  | (?P<string>"(?:[^"\\]|\\.)*")
  | (?P<directive>\#[ \t\r\n]*[A-Za-z_][A-Za-z0-9_]*)
  | (?P<bulk>(?:{_BULK_VECTOR}\s*+,?\s*+){{24,}}+)
  | (?P<punctuation><=|>=|!=|[-()<>\[\]{{}},;:.=+*/?!&|])
    """,
    re.VERBOSE | re.DOTALL,
)
_BLANKED: Final = str.maketrans("<>,", "   ")

PUNCTUATION: Final = {
    "(": "LPAR", ")": "RPAR", "<": "LESS", ">": "MORE", "[": "LSQB", "]": "RSQB", "{": "LBRACE", "}": "RBRACE",
    ",": "COMMA", ";": "SEMICOLON", ":": "COLON", ".": "DOT", "=": "EQUAL", "+": "PLUS", "-": "MINUS", "*": "STAR",
    "/": "SLASH", "?": "QUESTION", "!": "BANG", "&": "AND", "|": "OR", "<=": "LESSEQ", ">=": "MOREEQ", "!=": "NOTEQ",
}  # fmt: skip

_KIND_TERMINAL: Final = {
    Kind.CONSTANT: "CONSTANT",
    Kind.UNARY_FUNCTION: "UNARY_FUNCTION",
    Kind.FUNCTION: "FUNCTION",
    Kind.RGB: "RGB",
    Kind.WORD: "WORD",
}

# Directives that 3.7 still takes without '#'.
_BARE_DIRECTIVES: Final = {"declare": "DECLARE", "include": "INCLUDE"}

_ESCAPES: Final = {"a": "\a", "b": "\b", "f": "\f", "n": "\n", "r": "\r", "t": "\t", "v": "\v", "0": "\0"}
_ESCAPE: Final = re.compile(r"\\(u[0-9A-Fa-f]{4}|.)", re.DOTALL)

# Words whose terminal the grammar needs to tell apart from the rest.
_SPECIAL_WORDS: Final = {
    "function": "FUNCTION_WORD",
    "deprecated": "DEPRECATED",
    "default": "DEFAULT_WORD",
    "once": "ONCE",
}


def unescape(raw: str) -> str:
    """The text of a string literal. Where a file name stands, 3.7 takes the raw text instead."""

    def one(match: re.Match[str]) -> str:
        code = match[1]
        return chr(int(code[1:], 16)) if len(code) == 5 else _ESCAPES.get(code, code)

    return _ESCAPE.sub(one, raw)


def terminals(version: float) -> dict[str, str]:
    """The terminal of every word that is reserved in ``version``."""
    table = {k.name: _KIND_TERMINAL[k.kind] for k in KEYWORDS.values() if k.since <= version}
    if "optional" in table:
        table["optional"] = "OPTIONAL"
    if version >= 3.8:
        table |= {"local": "SCOPE", "global": "SCOPE"}
    return table | _SPECIAL_WORDS | _BARE_DIRECTIVES


_TERMINALS_37: Final = terminals(3.7)
_TERMINALS_38: Final = terminals(3.8)
_VERSION_38: Final = re.compile(r"#\s*version\s+(?:unofficial\s+)?3\.[89]")


_BEFORE_RUN: Final = frozenset({"", "RBRACE", "RPAR", "SEMICOLON", "LBRACE", "END", "ELSE"})


def speaks_38(text: str) -> bool:
    """Whether ``text`` asks for version 3.8, whose keywords are identifiers before."""
    return _VERSION_38.search(text) is not None


def tokenize(
    text: str, path: str = "", start: int = 0, version_38: bool | None = None, runs: bool = False
) -> Iterator[Token]:
    """All tokens of ``text``, or those from ``start`` on, where lines and columns then count from.

    ``version_38`` is said where it was found out before; with ``runs``, many statements alike in a row are one token.

    Raises:
        SdlSyntaxError: an unclosed comment or string, or a character that SDL does not know.
    """
    table = _TERMINALS_38 if (speaks_38(text) if version_38 is None else version_38) else _TERMINALS_37
    match_token = _TOKEN.match
    at, line, line_start, end = start, 1, start, len(text)
    previous = ""
    holes = 0
    no_run_before = 0 if runs else end
    while at < end:
        match = match_token(text, at)
        column = at - line_start + 1
        if match is None:
            raise _unreadable(text, at, path, line, column)
        kind, value, start = match.lastgroup, match.group(), at
        at = match.end()
        if kind == "word":
            if start >= no_run_before and previous in _BEFORE_RUN:
                run, no_run_before = find_run(text, start, line, table is _TERMINALS_38)
                if run is not None:
                    at, previous = no_run_before, "STATEMENTS"
                    yield Token(previous, run, start, line, column, line, column, at)
                    line += text.count("\n", start, at)
                    line_start = text.rfind("\n", 0, at) + 1
                    continue
            previous = table.get(value, "NAME")
            yield Token(previous, value, start, line, column, line, column, at)
            continue
        if kind == "punctuation":
            previous = PUNCTUATION[value]
            yield Token(previous, value, start, line, column, line, column, at)
            continue
        if kind == "number":
            previous = "NUMBER"
            yield Token(previous, value, start, line, column, line, column, at)
            if (match_token(text, at) and text[at] in "._") or text[at : at + 1].isalpha():
                raise SdlSyntaxError(f"malformed number '{_run(text, start)}'", path, line, column)
            continue
        if kind == "hole":
            previous = "HOLE"
            yield Token(previous, str(holes), start, line, column, line, column, at)
            holes += 1
            continue
        if kind == "fault":
            previous = "FAULT"
            yield Token(previous, value, start, line, column, line, column, at)
            continue
        if kind == "comment":
            closed = comment_end(text, start)
            if closed is None:
                hint = "add */ where it should end"
                raise SdlSyntaxError("this comment is never closed", path, line, column, hint)
            at = closed
            value = text[start:at]
        elif kind == "string":
            previous = "STRING"
            yield Token(previous, value[1:-1], start, line, column, line, column, at)
        elif kind == "directive":
            previous = _directive(value, path, line, column)
            yield Token(previous, value, start, line, column, line, column, at)
        elif kind == "bulk":
            if previous not in {"COMMA", "LBRACE"} or text[at : at + 1] in {*"+-*/.?"}:
                previous = "LESS"
                at = start + 1
                yield Token(previous, "<", start, line, column, line, column, at)
                continue
            previous = "BULK"
            yield Token(previous, _bulk(value), start, line, column, line, column, at)
        newlines = value.count("\n")
        if newlines:
            line += newlines
            line_start = start + value.rindex("\n") + 1


def _directive(value: str, path: str, line: int, column: int) -> str:
    word = value[1:].lstrip()
    if word not in DIRECTIVES:
        close = get_close_matches(word, DIRECTIVES, 1)
        hint = f"did you mean '#{close[0]}'?" if close else None
        raise SdlSyntaxError(f"unknown directive '#{word}'", path, line, column, hint)
    return word.upper()


def _bulk(value: str) -> Any:
    size = value[: value.index(">")].count(",") + 1
    numbers = np.fromstring(value.translate(_BLANKED), sep=" ")
    if len(numbers) != size * value.count("<"):
        return None
    return numbers.reshape(-1, size), value.rstrip().endswith(",")


def _run(text: str, at: int) -> str:
    match = re.compile(r"[\w.]+").match(text, at)
    return match.group() if match else text[at]


def _unreadable(text: str, at: int, path: str, line: int, column: int) -> SdlSyntaxError:
    if text[at] == '"':
        return SdlSyntaxError("this string is never closed", path, line, column, 'add " where it should end')
    return SdlSyntaxError(f"unexpected character {text[at]!r}", path, line, column)


@dataclass(frozen=True, slots=True)
class Source:
    """What is to be parsed: ``tokenize`` says what most of it means.

    With ``is_macro``, the text is a function's body: it tells the names that are macros by now. ``faults`` says what is
    wrong where `faults.FAULT` stands.
    """

    text: str
    path: str = ""
    version_38: bool | None = None
    runs: bool = False
    is_macro: Callable[[str], bool] | None = None
    faults: Mapping[int, SdlSyntaxError] = field(default_factory=dict)


class SdlLexer(Lexer):
    """The tokenizer in the shape that Lark asks for, braces matched."""

    def __init__(self, lexer_conf: Any) -> None:
        """Lark hands over its configuration; the table of keywords says all that is needed."""

    def lex(self, data: Source) -> Iterator[Token]:  # type: ignore[override]  # to Lark the data is any object
        """Tokens of a source, marked as the grammar expects them."""
        from minipov.grammar.braces import mark_loose_braces
        from minipov.grammar.function_bodies import function_tokens, mark_function_bodies

        tokens: Sequence[Token] = list(tokenize(data.text, data.path, 0, data.version_38, data.runs))
        for token in tokens if data.faults else ():
            if token.type == "FAULT":
                token.value = data.faults[token.start_pos or 0]
        tokens = mark_function_bodies(tokens, data.text)
        if data.is_macro is not None:
            tokens = function_tokens(tokens, data.is_macro)
        return iter(mark_loose_braces(tokens))
