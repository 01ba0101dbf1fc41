"""The language: text to tokens to tree."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from minipov.grammar.errors import SdlSyntaxError

if TYPE_CHECKING:
    from minipov.grammar.lexer import tokenize
    from minipov.grammar.parser import parse

__all__ = ["SdlSyntaxError", "parse", "tokenize"]


def __getattr__(name: str) -> Any:
    """Load the lexer and the parser when first asked for: a scene whose code is cached needs neither."""
    if name == "parse":
        from minipov.grammar.parser import parse

        return parse
    if name == "tokenize":
        from minipov.grammar.lexer import tokenize

        return tokenize
    raise AttributeError(name)
