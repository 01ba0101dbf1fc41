"""Tokens to tree: Lark's LALR(1) parser builds the nodes of `tree` directly.

>>> parse("sphere { 0, 1 }").items[0].name
'sphere'
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from functools import cache
from importlib.resources import files
from typing import Any

import lark
from lark import Lark
from lark.exceptions import UnexpectedInput
from lark.parsers.lalr_interactive_parser import InteractiveParser
from minipov.grammar import tree
from minipov.grammar.builder import Builder
from minipov.grammar.errors import SdlSyntaxError
from minipov.grammar.explain import explain
from minipov.grammar.faults import Faults
from minipov.grammar.lexer import SdlLexer, Source
from platformdirs import user_cache_path


@cache
def _parser() -> Lark:
    """Lark's parser; its tables are kept in the user's cache (0.05 s to load, 0.5 s to make), for each grammar."""
    grammar = (files("minipov.grammar") / "sdl.lark").read_text()
    state = hashlib.blake2b(grammar.encode(), digest_size=6).hexdigest()
    tables = user_cache_path("minipov", ensure_exists=True) / f"sdl-{lark.__version__}-{state}.tables"
    return Lark(
        grammar, parser="lalr", lexer=SdlLexer, transformer=Builder(_items), maybe_placeholders=False, cache=str(tables)
    )


def _items(text: str, version_38: bool) -> tuple[tree.Item, ...]:
    items: Any = _parser().parse(Source(text, "", version_38))
    return items  # type: ignore[no-any-return]  # the start rule gives items


def parse(text: str, path: str = "", runs: bool = False) -> tree.File:
    """The tree of a whole file; with ``runs``, many statements alike in a row become one `tree.Statements`.

    Raises:
        SdlSyntaxError: the text is not SDL.
    """
    try:
        items: Any = _parser().parse(Source(text, path, runs=runs))
    except UnexpectedInput as error:
        raise explain(error, text, path) from None
    return tree.File(path, items)


def parse_what_runs(text: str, path: str) -> tree.File:
    """As `parse` with ``runs``, but a mistake in the body of a directive is a `tree.Fault`: it may never be reached.

    Raises:
        SdlSyntaxError: what always runs is not SDL.
    """
    faults = Faults(text)
    while True:
        try:
            items: Any = _parser().parse(Source(faults.text, path, runs=True, faults=faults.errors))
            return tree.File(path, items)
        except UnexpectedInput as unexpected:
            error = explain(unexpected, faults.text, path)
        except SdlSyntaxError as found:
            error = found
        if not faults.take_out(error):
            raise error


def parse_function(text: str, path: str, line: int, column: int, is_macro: Callable[[str], bool]) -> tree.File:
    """The tokens of a function's body, which begins at a line and column, and the directives among them.

    Raises:
        SdlSyntaxError: a directive is not SDL.
    """
    padded = "\n" * (line - 1) + " " * (column - 1) + text
    try:
        items: Any = _parser().parse(Source(padded, path, is_macro=is_macro))
    except UnexpectedInput as error:
        raise explain(error, padded, path) from None
    return tree.File(path, items)


def interactive_parser() -> InteractiveParser:
    """Lark's parser to be fed with tokens one by one: for tools that go on after a mistake."""
    return _parser().parse_interactive()
