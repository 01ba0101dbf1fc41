"""What all nodes of a parsed file have."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Node:
    """Where a piece of the text begins."""

    line: int
    column: int
