"""From Lark's 'unexpected token' to what a person needs: what is wrong, where, and what would fix it."""

from __future__ import annotations

from difflib import get_close_matches
from typing import Final

from lark import Token
from lark.exceptions import UnexpectedInput
from minipov.grammar.errors import SdlSyntaxError
from minipov.grammar.keywords import KEYWORDS, OPENING
from minipov.grammar.lexer import tokenize

_TERMINAL_NAMES: Final = {
    "COMMA": "','", "SEMICOLON": "';'", "LBRACE": "'{'", "RBRACE": "'}'", "LPAR": "'('", "RPAR": "')'",
    "LSQB": "'['", "RSQB": "']'", "LESS": "'<'", "MORE": "'>'", "EQUAL": "'='", "COLON": "':'", "NAME": "an identifier",
    "NUMBER": "a number", "STRING": "a string", "END": "#end",
}  # fmt: skip

_CLOSERS: Final = {"LPAR": "RPAR", "LESS": "MORE", "LSQB": "RSQB", "LBRACE": "RBRACE"}
_OPERAND_ENDS: Final = frozenset({"NUMBER", "NAME", "RPAR", "MORE", "CONSTANT", "RSQB", "STRING"})


def explain(error: UnexpectedInput, text: str, path: str) -> SdlSyntaxError:
    """The error in SDL's own terms."""
    token: Token | None = getattr(error, "token", None)
    if token is None or token.type == "$END":
        return _unclosed(text, path)
    line, column = token.line or 0, token.column or 0
    if token.type == "LOOSE_LPAR":
        return SdlSyntaxError("this '(' is never closed", path, line, column, "add ) where it should end")
    if token.type in {"RBRACE", "RPAR", "RSQB", "END", "LOOSE_RPAR"} and (opener := _innermost(text, token)):
        closer = _TERMINAL_NAMES[_CLOSERS[opener.type]] if opener.type in _CLOSERS else "#end"
        message = f"unexpected '{token}', expected {closer}"
        opened = (opener.line or 0, opener.column or 0)
        return SdlSyntaxError(message, path, line, column, f"'{opener}' was opened at line {opener.line}", opened)
    if token.type == "END":
        return SdlSyntaxError("this #end closes nothing", path, line, column)
    found = "a string" if token.type == "STRING" else f"'{token}'"
    message = f"unexpected {found}"
    expected = set(getattr(error, "expected", None) or getattr(error, "accepts", None) or ())
    if 0 < len(expected) <= 3:
        message += ", expected " + " or ".join(sorted(_TERMINAL_NAMES.get(e, e.lower()) for e in expected))
    return SdlSyntaxError(message, path, line, column, _hint(token, expected))


def _hint(token: Token, expected: set[str]) -> str | None:
    if token.type in {"WORD", "CONSTANT", "FUNCTION", "UNARY_FUNCTION", "RGB"} and "NAME" in expected:
        return f"'{token}' is a reserved word; a name with a capital letter never is"
    if token.type == "MORE":
        return "a '<' after a value compares; put a comma before a vector"
    if token.type == "NAME" and (close := get_close_matches(token, KEYWORDS, 1)):
        return f"did you mean '{close[0]}'?"
    return None


def _open_at(text: str, stop: int | None) -> list[Token]:
    """What is still open before position ``stop`` (None: at the end): brackets, and directives that need an ``#end``.

    A ``<`` counts only when it opens a vector, which shows in what stands before it.
    """
    stack: list[Token] = []
    previous = ""
    for token in tokenize(text):
        if stop is not None and token.start_pos is not None and token.start_pos >= stop:
            break
        kind = token.type
        if kind in OPENING or kind in {"LPAR", "LBRACE", "LSQB"} or (kind == "LESS" and previous not in _OPERAND_ENDS):
            stack.append(token)
        elif stack and (kind == _CLOSERS.get(stack[-1].type) or (kind == "END" and stack[-1].type in OPENING)):
            stack.pop()
        previous = kind
    return stack


def _bare_comparison(text: str) -> Token | None:
    """The first ``<`` after a value and outside parentheses, which the parser takes for the start of a vector."""
    depth, previous = 0, ""
    for token in tokenize(text):
        depth += {"LPAR": 1, "RPAR": -1}.get(token.type, 0)
        if token.type == "LESS" and previous in _OPERAND_ENDS and depth == 0:
            return token
        previous = token.type
    return None


def _innermost(text: str, token: Token) -> Token | None:
    stack = _open_at(text, token.start_pos)
    return stack[-1] if stack else None


def _unclosed(text: str, path: str) -> SdlSyntaxError:
    stack = _open_at(text, None)
    if not stack and (less := _bare_comparison(text)):
        message = "this '<' opens a vector that is never closed"
        hint = "a comparison stands in parentheses: (A < B)"
        return SdlSyntaxError(message, path, less.line or 0, less.column or 0, hint)
    if not stack:
        last = text.count("\n") + 1
        return SdlSyntaxError("the file ends in the middle of a statement", path, last, 1)
    opener = stack[-1]
    closer = _TERMINAL_NAMES[_CLOSERS[opener.type]].strip("'") if opener.type in _CLOSERS else "#end"
    message = f"'{opener}' is never closed: {closer} is missing"
    return SdlSyntaxError(message, path, opener.line or 0, opener.column or 0, f"add {closer} where it should end")
