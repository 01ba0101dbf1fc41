"""The bad scenes: each a mistake, with what is to be said about it in its header.

    // what the mistake is
    // error: 4:13 'Radius'      line:column and a part of the message; or file:line:column for another file
    // hint: did you mean ...    a part of the hint, where one is expected

``// warning:`` instead of ``// error:`` marks what only deserves a warning. POV-Ray agrees about which is which.
"""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

FOLDER = Path(__file__).parent


@dataclass(frozen=True, slots=True)
class BadScene:
    """One scene and what is expected of its message."""

    path: Path
    kind: Literal["error", "warning"]
    place: str
    part: str
    hint: str


def read_bad_scene(path: Path) -> BadScene:
    """Read one file."""
    text = path.read_text(encoding="utf-8")
    found = re.search(r"^// (error|warning): (\S+) ?(.*)$", text, re.MULTILINE)
    assert found is not None, f"{path.name} does not say what is wrong with it"
    kind: Literal["error", "warning"] = "error" if found[1] == "error" else "warning"
    place = found[2] if found[2].count(":") == 2 else f"{path.name}:{found[2]}"
    hint = re.search(r"^// hint: (.*)$", text, re.MULTILINE)
    return BadScene(path, kind, place, found[3], hint[1] if hint else "")


BAD_SCENES = tuple(read_bad_scene(path) for path in sorted(FOLDER.glob("*.pov")))
