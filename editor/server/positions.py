"""Offsets in a text, and lines and characters as the client counts them."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence

from lsprotocol import types
from pygls.workspace import PositionCodec


class Positions:
    """Translates for one text with lines at ``starts``; ``codec`` knows in which units the client counts characters."""

    def __init__(self, text: str, starts: Sequence[int], codec: PositionCodec) -> None:
        self.text = text
        self.starts = starts
        self.codec = codec
        self.plain = text.isascii()

    def offset(self, position: types.Position) -> int:
        """The offset of a position; what lies outside the text is taken to its nearest end."""
        if position.line >= len(self.starts):
            return len(self.text)
        start = self.starts[position.line]
        end = self.starts[position.line + 1] - 1 if position.line + 1 < len(self.starts) else len(self.text)
        if self.plain:
            return min(start + position.character, end)
        line = self.text[start:end]
        moved = self.codec.position_from_client_units([line], types.Position(0, position.character))
        return start + min(moved.character, len(line))

    def position(self, offset: int) -> types.Position:
        """The position of an offset."""
        line = bisect_right(self.starts, offset) - 1
        start = self.starts[line]
        if self.plain:
            return types.Position(line, offset - start)
        return types.Position(line, self.codec.client_num_units(self.text[start:offset]))

    def range(self, start: int, end: int) -> types.Range:
        """The range between two offsets."""
        return types.Range(self.position(start), self.position(end))
