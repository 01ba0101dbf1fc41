"""The values of SDL: floats are Python floats, vectors and colours one immutable type.

A float beside a vector is copied to all terms; a shorter vector is padded with zeros; operators work term by term.
"""

from __future__ import annotations

from collections.abc import Iterable


class Vector(tuple[float, ...]):
    """Two to five terms: a vector, or with five terms a colour (red, green, blue, filter, transmit)."""

    __slots__ = ()

    def __new__(cls, terms: Iterable[float]) -> Vector:
        return super().__new__(cls, terms)

    def padded(self, size: int) -> tuple[float, ...]:
        """The terms, with zeros up to ``size``."""
        return self + (0.0,) * (size - len(self))
