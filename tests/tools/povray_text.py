"""Run POV-Ray for what it says, not for a picture: the lines of ``#debug``, the errors, the warnings."""

import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

PROGRAM = shutil.which("povray")
"""None where POV-Ray is not installed."""


@dataclass(frozen=True, slots=True)
class Said:
    """Exit status, the lines of the debug stream, and the text of the fatal and warning streams."""

    status: int
    debug: tuple[str, ...]
    fatal: str
    warnings: str


def run_povray(scene: Path, work: Path, switches: Sequence[str] = ()) -> Said:
    """Parse ``scene`` and render one pixel of it in the empty folder ``work``, where its files go too."""
    assert PROGRAM is not None
    streams = ["-GA", "+GDdebug", "+GFfatal", "+GWwarning"]
    command = [PROGRAM, f"+I{scene}", f"+L{scene.parent}", "-F", "+W1", "+H1", "-D", "+WT1", *streams, *switches]
    done = subprocess.run(command, cwd=work, stdin=subprocess.DEVNULL, capture_output=True, timeout=120, check=False)

    def stream(name: str) -> str:
        file = work / name
        return file.read_text(encoding="utf-8", errors="replace") if file.exists() else ""

    lines = (line.rstrip() for line in stream("debug").splitlines())
    return Said(done.returncode, tuple(lines), stream("fatal"), stream("warning"))
