"""The language: text to tokens to tree."""

from minipov.grammar.errors import SdlSyntaxError
from minipov.grammar.lexer import tokenize
from minipov.grammar.parser import parse

__all__ = ["SdlSyntaxError", "parse", "tokenize"]
