"""The keywords in the groups that are coloured alike."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from minipov.editor.analysis.language import BLOCKS
from minipov.grammar.keywords import DIRECTIVES, DIVIDING, KEYWORDS, OPENING, Kind

CONTROL: Final = frozenset(map(str.lower, OPENING | DIVIDING | {"BREAK", "END"})) - {"macro"}
"""The directives that steer what is read."""

CONSTANTS: Final = frozenset(k.name for k in KEYWORDS.values() if k.kind is Kind.CONSTANT)
FUNCTIONS: Final = frozenset(k.name for k in KEYWORDS.values() if k.kind in {Kind.FUNCTION, Kind.UNARY_FUNCTION})
COLORS: Final = frozenset(k.name for k in KEYWORDS.values() if k.kind is Kind.RGB) | {"color", "colour"}
BLOCK_WORDS: Final = BLOCKS & KEYWORDS.keys()
"""The words that begin a block."""
OTHER_WORDS: Final = KEYWORDS.keys() - CONSTANTS - FUNCTIONS - COLORS - BLOCK_WORDS
DECLARING: Final = DIRECTIVES.keys() - CONTROL
"""The other directives."""


def alternatives(words: Iterable[str]) -> str:
    """A regular expression for whole words."""
    return rf"\b(?:{'|'.join(sorted(words))})\b"
