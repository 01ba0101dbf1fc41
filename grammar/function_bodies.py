"""What only the running program can read of ``function { ... }``: directives inside, macros that give half a sum.

::

    function { 0 #for (I, 1, 3) + pow(x, I)/I #end }
    function { 2*M() Rest(3) }

A function's body is a row of tokens, which directives and macros may add to. Where a body is plain, the grammar reads
it (`mark_function_bodies` leaves it alone, and keeps its text at its brace, should a macro be called in it). Else it
becomes one token, FUNCTION_TEXT, and is parsed when the scene runs: then macros are known (`function_tokens`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Final

from lark import Token
from minipov.grammar.keywords import DIRECTIVE_TOKENS, DIVIDING, OPENING

_HEADED: Final = (OPENING | DIVIDING | {"READ", "WRITE"}) - {"ELSE", "MACRO"}
_SPEAKING: Final = frozenset(
    {"INCLUDE", "DEBUG", "WARNING", "ERROR", "RENDER", "STATISTICS", "UNDEF", "VERSION", "FCLOSE"}
)
_CALLABLE: Final = frozenset({"NAME", "FUNCTION", "UNARY_FUNCTION"})
_OPERANDS: Final = frozenset({"NUMBER", "CONSTANT", *_CALLABLE})
_ENDS: Final = frozenset({"NUMBER", "CONSTANT", "NAME", "RPAR", "RSQB"})
_BRACKETS: Final = {"LPAR": "RPAR", "LSQB": "RSQB", "LBRACE": "RBRACE"}


def mark_function_bodies(tokens: Sequence[Token], text: str) -> Sequence[Token]:
    """The same tokens: the brace of a function's body holds the body's text; a body that is not plain is one token."""
    starts = [number for number, token in enumerate(tokens) if token.type == "FUNCTION_WORD"]
    if not starts:
        return tokens
    marked: list[Token] = []
    done = 0
    for start in starts:
        opening = next((at for at in range(start, len(tokens)) if tokens[at].type == "LBRACE"), None)
        closing = opening and _closing(tokens, opening)
        if start < done or not opening or not closing:
            continue
        body = tokens[opening + 1 : closing]
        if not body or _is_block(body):
            continue
        brace = tokens[opening]
        source = text[brace.end_pos : tokens[closing].start_pos]
        marked += [*tokens[done:opening], brace.update(value=source)]
        marked += body if _is_plain(body) else [body[0].update("FUNCTION_TEXT", source)]
        done = closing
    return [*marked, *tokens[done:]]


def _closing(tokens: Sequence[Token], opening: int) -> int | None:
    """Where the bracket at ``opening`` is closed."""
    opener, depth = tokens[opening].type, 0
    for at in range(opening, len(tokens)):
        depth += (tokens[at].type == opener) - (tokens[at].type == _BRACKETS[opener])
        if not depth:
            return at
    return None


def _is_block(body: Sequence[Token]) -> bool:
    """``pattern { ... }``, ``internal(7)``."""
    return body[0].type == "WORD"


def _is_plain(body: Sequence[Token]) -> bool:
    """Whether there are neither directives nor operands side by side, which only a macro can join."""
    previous = ""
    for token in body:
        if token.type in DIRECTIVE_TOKENS or (token.type in _OPERANDS and previous in _ENDS):
            return False
        previous = token.type
    return True


def function_tokens(tokens: Sequence[Token], is_macro: Callable[[str], bool]) -> Sequence[Token]:
    """The tokens of a body, marked as such; directives, calls of macros and elements of arrays stay as they are."""
    marked: list[Token] = []
    at = 0
    while at < len(tokens):
        end = _plain_end(tokens, at, is_macro)
        if end > at:
            marked += tokens[at:end]
            at = end
            continue
        token = tokens[at]
        marked.append(token.update("FUNCTION_NAME" if token.type == "NAME" else "FUNCTION_TOKEN"))
        at += 1
    return marked


def _plain_end(tokens: Sequence[Token], at: int, is_macro: Callable[[str], bool]) -> int:
    """The end of what is not part of the function's expression but begins at ``at``; ``at`` itself if it is part."""
    token = tokens[at]
    following = tokens[at + 1].type if at + 1 < len(tokens) else ""
    if token.type in ("DECLARE", "LOCAL"):
        return next((end + 1 for end in range(at, len(tokens)) if tokens[end].type == "SEMICOLON"), len(tokens))
    if token.type in _SPEAKING:
        return _value_end(tokens, at + 1)
    if token.type == "FOPEN":
        return _value_end(tokens, at + 2) + 1
    if token.type == "MACRO":
        return _matching_end(tokens, at)
    if token.type in DIRECTIVE_TOKENS:
        return _value_end(tokens, at) if token.type in _HEADED else at + 1
    if token.type == "NAME" and following == "LPAR" and is_macro(token):
        return _value_end(tokens, at)
    if token.type == "NAME" and following == "LSQB":
        end = at + 1
        while end < len(tokens) and tokens[end].type == "LSQB":
            end = (_closing(tokens, end) or len(tokens)) + 1
        return end
    return at


def _value_end(tokens: Sequence[Token], at: int) -> int:
    """The end of a token and the parentheses after it."""
    if at + 1 < len(tokens) and tokens[at + 1].type == "LPAR":
        return (_closing(tokens, at + 1) or len(tokens)) + 1
    return at + 1


def _matching_end(tokens: Sequence[Token], at: int) -> int:
    """The end of a whole ``#macro``."""
    depth = 0
    for end in range(at, len(tokens)):
        depth += tokens[end].type in OPENING
        depth -= tokens[end].type == "END"
        if not depth:
            return end + 1
    return len(tokens)
