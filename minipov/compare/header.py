"""The comment lines that open our scenes.

::

    // A sphere on a checkered plane
    // class: close — the light is sampled
    // switches: +A0.3 -J
"""

from __future__ import annotations

import re
import shlex
from dataclasses import dataclass
from pathlib import Path

from minipov.compare.verdict import VERDICTS, Verdict

_FIELD = re.compile(r"//\s*(class|switches):\s*(.*)")


@dataclass(frozen=True, slots=True)
class SceneHeader:
    """What a scene says of itself; ``expected`` is None where it names no class."""

    title: str = ""
    expected: Verdict | None = None
    switches: tuple[str, ...] = ()


def read_header(scene: Path) -> SceneHeader:
    """Read the comment lines at the top of ``scene``."""
    title = ""
    expected: Verdict | None = None
    switches: tuple[str, ...] = ()
    for line in scene.read_text("utf-8", "replace").splitlines():
        if not line.startswith("//"):
            break
        match = _FIELD.match(line)
        if match is None:
            title = title or line.lstrip("/ ").strip()
        elif match.group(1) == "class":
            named = re.split(r"[\s—-]", match.group(2).strip())[0]
            expected = next((verdict for verdict in VERDICTS if verdict == named), None)
        else:
            switches = tuple(shlex.split(match.group(2)))
    return SceneHeader(title, expected, switches)
