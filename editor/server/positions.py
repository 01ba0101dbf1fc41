"""Offsets in a text, and lines and characters as the client counts them."""

from __future__ import annotations

from bisect import bisect_right

from lsprotocol import types
from minipov.editor.analysis.document import Document
from pygls.workspace import PositionCodec


class Positions:
    """Translates for one document; ``codec`` knows in which units the client counts characters."""

    def __init__(self, document: Document, codec: PositionCodec) -> None:
        self.document = document
        self.codec = codec
        self.plain = document.text.isascii()

    def offset(self, position: types.Position) -> int:
        """The offset of a position; what lies outside the text is taken to its nearest end."""
        starts = self.document.line_starts
        if position.line >= len(starts):
            return len(self.document.text)
        start = starts[position.line]
        end = starts[position.line + 1] - 1 if position.line + 1 < len(starts) else len(self.document.text)
        if self.plain:
            return min(start + position.character, end)
        line = self.document.text[start:end]
        moved = self.codec.position_from_client_units([line], types.Position(0, position.character))
        return start + min(moved.character, len(line))

    def position(self, offset: int) -> types.Position:
        """The position of an offset."""
        line = bisect_right(self.document.line_starts, offset) - 1
        start = self.document.line_starts[line]
        if self.plain:
            return types.Position(line, offset - start)
        return types.Position(line, self.codec.client_num_units(self.document.text[start:offset]))

    def range(self, start: int, end: int) -> types.Range:
        """The range between two offsets."""
        return types.Range(self.position(start), self.position(end))
