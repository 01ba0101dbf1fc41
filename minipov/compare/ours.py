"""minipov's picture of a scene, made in a process of its own so that no scene can stop the comparison."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from minipov.compare.rendering import PICTURE, Rendering, run_renderer


def run_minipov(scene: Path, switches: Sequence[str], work: Path, timeout: float) -> Rendering:
    """Render ``scene`` with POV-Ray's ``switches`` in the empty folder ``work``."""
    program = [sys.executable, "-P", "-m", "minipov"]
    scene = scene.resolve()
    options = [f"+I{scene}", f"+O{PICTURE}", f"+L{scene.parent}", "--statistics", "-A", "+WT1", *switches]
    return run_renderer([*program, *options], work, timeout)
