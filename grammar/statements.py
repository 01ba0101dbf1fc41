"""Runs of statements alike, as programs write them: 100,000 times ``sphere { <1, 2, 3>, 4 texture {...} }``.

A statement whose numbers are taken out is a shape. What follows is compiled once for each shape; the statements
themselves are rows of numbers.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

HOLE: Final = "\x01"
"""Stands in a shape where a number was."""

_LEAST: Final = 24
_DEEPEST: Final = 6
_LONGEST: Final = 4000
_WORDS: Final = (
    "sphere|cylinder|box|cone|torus|disc|plane|triangle|smooth_triangle|polygon|object|union|merge|intersection"
    "|difference|light_source|mesh|mesh2|superellipsoid"
)
# A number, with its sign where that can be no operator. It begins with a set of characters: Python finds these fast.
_NUMBER: Final = re.compile(
    r"""(
    [-+.\d]
    (?: (?<=[-+]) (?: (?<=[<,({].) | (?<=[<,({][ ].) ) (?>\d+\.?\d*|\.\d+)
      | (?<=\d) (?<![\w.].) (?>\d*\.?\d*)
      | (?<=\.) (?<![\w.].) (?>\d+) )
    (?>(?:[eE][+-]?\d+)?) (?![\w.])
    )""",
    re.VERBOSE,
)


def _nested(opening: str, closing: str, depth: int) -> str:
    """A pattern for what stands between two brackets, themselves included; no directives and no comments."""
    inner = rf"""[^{opening}{closing}"#/]++|"[^"\\\n]*+"|/(?![/*])"""
    if depth:
        inner += "|" + _nested(opening, closing, depth - 1)
    return rf"\{opening}(?:{inner})*+\{closing}"


_STATEMENT: Final = re.compile(
    rf"(?:{_WORDS})\b\s*+{_nested('{', '}', _DEEPEST)}"
    rf"|[A-Z_]\w*+\s*+{_nested('(', ')', 2)}(?=\s*+[A-Za-z_]|\s*+\Z)"
)
_CLOSING: Final = re.compile("[})]")
_BLANKS: Final = re.compile(r"\s*+")


@dataclass(frozen=True, slots=True)
class Run:
    """Statements in a row. ``shapes`` are texts with `HOLE` for every number that varies.

    ``order`` holds for each statement the number of its shape, ``lines`` where it begins; the rows of ``numbers``,
    one array for each shape, are in the order of the statements; ``starts`` are the line and column of each shape.
    """

    shapes: tuple[str, ...]
    starts: tuple[tuple[int, int], ...]
    order: tuple[int, ...]
    lines: tuple[int, ...]
    numbers: tuple[NDArray[np.float64], ...]
    version_38: bool

    def __str__(self) -> str:
        return f"{len(self.order)} statements"


def find_run(text: str, start: int, line: int, version_38: bool) -> tuple[Run | None, int]:
    """The statements in a row from ``start``, and where they end; None where they are too few or too different."""
    shapes: dict[str, int] = {}
    starts: list[tuple[int, int]] = []
    order: list[int] = []
    lines: list[int] = []
    numbers: list[list[str]] = []
    at, counted = start, start
    if not _may_begin(text, start):
        return None, start + 1
    while statement := _STATEMENT.match(text, at):
        line += text.count("\n", counted, at)
        counted = at
        source = statement.group()
        if "function" in source:  # what runs may need its text, numbers included
            break
        parts = _NUMBER.split(source)  # texts and numbers in turn
        shape = HOLE.join(parts[::2])
        number = shapes.get(shape)
        if number is None:
            if len(order) > _LEAST and len(shapes) > len(order) // 4:
                break
            number = shapes[shape] = len(shapes)
            starts.append((line, at - text.rfind("\n", 0, at)))
            numbers.append([])
        order.append(number)
        lines.append(line)
        numbers[number] += parts[1::2]
        end = statement.end()
        blanks = _BLANKS.match(text, end)
        at = blanks.end() if blanks else end
    if len(order) < _LEAST or len(shapes) > len(order) // 4:
        return None, at
    rows = [_rows(found, shape.count(HOLE)) for found, shape in zip(numbers, shapes, strict=True)]
    settled = [_settled(*parts) for parts in zip(shapes, numbers, rows, strict=True)]
    texts, varying = zip(*settled, strict=True)
    return Run(texts, tuple(starts), tuple(order), tuple(lines), varying, version_38), end


def _may_begin(text: str, start: int) -> bool:
    """Whether some statements could follow here: a quick look before the thorough one."""
    at = start
    for _ in range(3):
        first = _CLOSING.search(text, at, at + _LONGEST)
        if first is None:
            return False
        at = first.end()
    return True


def _rows(numbers: list[str], width: int) -> NDArray[np.float64]:
    """The numbers of all statements of a shape; one row each."""
    return np.array(list(map(float, numbers))).reshape(-1, width) if width else np.zeros((1, 0))


def _settled(shape: str, written: list[str], rows: NDArray[np.float64]) -> tuple[str, NDArray[np.float64]]:
    """A shape in which the numbers that never change stand again, everything at the column of the first statement."""
    same = (rows == rows[0]).all(axis=0)
    first = iter(zip(same, written, strict=False))

    def filled(_: re.Match[str]) -> str:
        constant, text = next(first)
        return text if constant else HOLE.rjust(len(text))

    return re.sub(HOLE, filled, shape), rows[:, ~same]
