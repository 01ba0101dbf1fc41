"""What is wrong in a text, and where."""

from __future__ import annotations

from dataclasses import dataclass, replace


@dataclass(frozen=True, slots=True)
class Problem:
    """A mistake at the offsets ``start`` to ``end``.

    ``certain`` is False where POV-Ray might still take it; ``opened`` is the offset of the bracket that is amiss.
    """

    start: int
    end: int
    message: str
    hint: str | None = None
    certain: bool = True
    opened: int | None = None

    def moved(self, by: int) -> Problem:
        """The same problem further down the text."""
        opened = None if self.opened is None else self.opened + by
        return replace(self, start=self.start + by, end=self.end + by, opened=opened)
