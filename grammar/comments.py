"""SDL: ``/* a comment /* with another */ inside */``."""

from __future__ import annotations

import re
from typing import Final

_EDGE: Final = re.compile(r"/\*|\*/")


def comment_end(text: str, start: int) -> int | None:
    """Where the comment that opens at ``start`` ends, with those that it holds; None if it is never closed."""
    depth = 0
    for edge in _EDGE.finditer(text, start):
        depth += 1 if edge.group() == "/*" else -1
        if depth == 0:
            return edge.end()
    return None
