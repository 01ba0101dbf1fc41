"""What the program ends with."""

from __future__ import annotations

from typing import Final

OK: Final = 0
SCENE_ERROR: Final = 1
"""The scene is wrong, or its picture cannot be written."""
USAGE_ERROR: Final = 2
INTERRUPTED: Final = 130
