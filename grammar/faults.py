"""Mistakes in text that may never run: POV-Ray reads only the branches that it takes and the macros that it calls.

``#if (0) don't read this: ( #else sphere { 0, 1 } #end`` is a sphere. A body of a directive that is not SDL becomes one
token, which raises its error where it is reached.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Final

from minipov.grammar.comments import comment_end
from minipov.grammar.errors import SdlSyntaxError
from minipov.grammar.keywords import DIVIDING, OPENING

FAULT: Final = "\x02"
"""Stands in the text where such a body begins; blanks fill the rest of it."""

_MARKS: Final = re.compile(
    r"""//[^\n]* | (?P<comment>/\*) | "(?:[^"\\]|\\.)*" | (?P<bracket>[()]) | \#[ \t\r\n]*(?P<word>[A-Za-z_]\w*)""",
    re.VERBOSE | re.DOTALL,
)
_OPENING: Final = frozenset(map(str.lower, OPENING))
_DIVIDING: Final = frozenset(map(str.lower, DIVIDING))
_NOT_BLANK: Final = re.compile(r"\S")


@dataclass
class Faults:
    """The text of a file, and what was found wrong in it so far, by where the body begins."""

    text: str
    errors: dict[int, SdlSyntaxError] = field(default_factory=dict)

    def take_out(self, error: SdlSyntaxError) -> bool:
        """Take the innermost body that holds an error out of the text; False if none does."""
        at = sum(len(line) + 1 for line in self.text.split("\n")[: error.line - 1]) + error.column - 1
        holding = [(start, end) for start, end in _bodies(self.text) if start <= at <= end and start < end]
        holding = [body for body in holding if body[0] not in self.errors]
        if not holding:
            return False
        start, end = max(holding)
        within = sorted(inner for inner in self.errors if start < inner < end)
        self.errors[start] = self.errors[within[0]] if within else error
        for inner in within:
            del self.errors[inner]
        blanked = _NOT_BLANK.sub(" ", self.text[start + 1 : end])
        self.text = self.text[:start] + FAULT + blanked + self.text[end:]
        return True


@dataclass
class _Open:
    """A directive that ``#end`` is still to close."""

    head: int | None
    """How many parentheses are open in its head; None where the head has been read or there is none."""
    starts: list[int] = field(default_factory=list)
    """Where its body begins, and where what ``#break`` skips."""


def _bodies(text: str) -> Iterator[tuple[int, int]]:
    """Where the bodies of directives begin and end, as far as they are closed; and what ``#break`` skips of them."""
    stack: list[_Open] = []
    at = 0
    while (mark := _MARKS.search(text, at)) is not None:
        at = mark.end()
        innermost = stack[-1] if stack else None
        if mark["comment"]:
            at = comment_end(text, mark.start()) or len(text)
        elif mark["bracket"] and innermost and innermost.head is not None:
            innermost.head += 1 if mark["bracket"] == "(" else -1
            if innermost.head <= 0:
                innermost.head = None
                innermost.starts.append(at)
        elif mark["word"]:
            word = mark["word"]
            if innermost and word in _DIVIDING | {"end"}:
                yield from ((start, mark.start()) for start in stack.pop().starts)
            if word == "else":
                stack.append(_Open(None, [at]))
            elif word in _OPENING | _DIVIDING:
                stack.append(_Open(0))
            elif innermost and word == "break" and innermost.head is None:
                innermost.starts.append(at)
