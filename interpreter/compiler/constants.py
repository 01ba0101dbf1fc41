"""Values that compiled code refers to but a code object cannot hold: vectors, words, arrays of numbers, runs of items.

They are written down as plain data (so that the whole file's code can be cached on disk) and made once when it is
loaded.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from minipov.interpreter.items import COMMA, SEMICOLON, Punctuation, Word
from minipov.interpreter.values import Vector
from numpy.typing import NDArray

Plain = Any
"""None, float, str, or a tuple that begins with its kind: ``("vector", ...)``, ``("word", name)``, ``("run", ...)``."""


class Constants:
    """The constants of one file: ``add`` gives the global name by which code reads one."""

    def __init__(self) -> None:
        self.plain: list[Plain] = []
        self._known: dict[Plain, str] = {}

    def add(self, plain: Plain) -> str:
        """The name of a constant, equal ones sharing it."""
        name = self._known.get(plain)
        if name is None:
            name = self._known[plain] = f"k{len(self.plain)}"
            self.plain.append(plain)
        return name


def plain_array(array: NDArray[np.float64]) -> Plain:
    """An array as plain data."""
    return ("array", array.shape, array.astype(np.float64).tobytes())


def revive(plain: Plain) -> Any:
    """The value of plain data."""
    if not isinstance(plain, tuple):
        return plain
    kind, *rest = plain
    match kind:
        case "vector":
            return Vector(rest[0])
        case "word":
            return _word(rest[0])
        case "punctuation":
            return {",": COMMA, ";": SEMICOLON}.get(rest[0]) or Punctuation(rest[0])
        case "array":
            shape, data = rest
            if not data:
                return np.zeros(shape)
            return np.frombuffer(data, dtype=np.float64).reshape(shape)
        case "rows":
            order, lines, arrays = rest
            return order, lines, tuple(revive(array) for array in arrays)
        case "run":
            return tuple(map(revive, rest[0]))
        case "places":
            file, pairs = rest
            return tuple((file, line, column) for line, column in pairs)
        case "place":
            return tuple(rest)
    raise ValueError(f"unknown kind of constant: {kind}")


_WORDS: dict[str, Word] = {}


def _word(name: str) -> Word:
    word = _WORDS.get(name)
    if word is None:
        word = _WORDS[name] = Word(name)
    return word
