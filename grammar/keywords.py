"""THE keyword table: every reserved word of SDL, what kind of word it is, since which version.

The lexer, the interpreter, the documentation and every editor grammar read this table.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Final

from minipov.grammar import function_words, other_words
from minipov.grammar.directive_words import DIRECTIVES as DIRECTIVE_LINES


class Kind(Enum):
    """What a keyword is to the grammar."""

    CONSTANT = "constant"
    """A value without arguments: ``x``, ``pi``, ``clock``, ``on``."""
    UNARY_FUNCTION = "unary function"
    """A float function of one float, whose argument may hold comparisons: ``abs(1<2)``."""
    FUNCTION = "function"
    """Any other function, called with an argument list."""
    RGB = "rgb"
    """``rgb``, ``srgbft``...: what follows is an expression that may hold comparisons."""
    WORD = "word"
    """Anything else: an object, a block, a modifier, a pattern..."""


@dataclass(frozen=True, slots=True)
class Keyword:
    """One reserved word. In a scene whose ``#version`` is below ``since`` it is an ordinary identifier.

    ``doc`` says in a few words what it is; functions and colours have a ``signature``.
    """

    name: str
    kind: Kind
    doc: str
    signature: str = ""
    since: float = 3.7


def _table(lines: str, kind: Kind, since: float = 3.7) -> dict[str, Keyword]:
    table = {}
    for line in lines.strip().splitlines():
        names, *signature, doc = (part.strip() for part in line.split("|"))
        for name in names.split():
            table[name] = Keyword(name, kind, doc, signature[0] if signature else "", since)
    return table


KEYWORDS: Final[dict[str, Keyword]] = {
    **_table(function_words.CONSTANTS, Kind.CONSTANT),
    **_table(function_words.CONSTANTS_38, Kind.CONSTANT, 3.8),
    **_table(function_words.UNARY_FUNCTIONS, Kind.UNARY_FUNCTION),
    **_table(function_words.FUNCTIONS, Kind.FUNCTION),
    **_table(function_words.RGB, Kind.RGB),
    **_table(other_words.WORDS, Kind.WORD),
    **_table(other_words.WORDS_38, Kind.WORD, 3.8),
}


def _directive_table(lines: str) -> dict[str, tuple[str, str]]:
    rows = ([part.strip() for part in line.split("|")] for line in lines.strip().splitlines())
    return {name: (form, doc) for names, form, doc in rows for name in names.split()}


DIRECTIVES: Final[dict[str, tuple[str, str]]] = _directive_table(DIRECTIVE_LINES)
"""The words that may follow ``#``, each with how it is written and what it does."""

DIRECTIVE_TOKENS: Final = frozenset(map(str.upper, DIRECTIVES))
"""The types of their tokens."""
OPENING: Final = frozenset(name.upper() for name, (form, _) in DIRECTIVES.items() if form.endswith("... #end"))
"""The types of those whose body ``#end`` closes."""
DIVIDING: Final = frozenset({"ELSE", "ELSEIF", "CASE", "RANGE"})
"""The types of those that end one body and begin the next."""
