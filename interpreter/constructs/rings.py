"""Rings of points, as polygons and prisms have them: a repeated first point closes one and the next starts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

P = TypeVar("P")


def open_ring_start(points: Sequence[P]) -> P | None:
    """The first point of the last ring if that ring is not closed, else None."""
    start: P | None = None
    for point in points:
        if start is None:
            start = point
        elif point == start:
            start = None
    return start
