"""Text that is not SDL: what was found, where, and what would have been right."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(slots=True)
class SdlSyntaxError(Exception):
    """A file that cannot be parsed; line and column count from 1. ``opened``: where the bracket opens that is amiss."""

    message: str
    path: str
    line: int
    column: int
    hint: str | None = None
    opened: tuple[int, int] | None = None

    def __str__(self) -> str:
        return f"{self.path}:{self.line}:{self.column}: error: {self.message}"
