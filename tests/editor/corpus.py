"""The files that POV-Ray ships, as documents."""

from __future__ import annotations

from pathlib import Path

from minipov.editor.analysis.library import Library

FOLDERS = (Path("/usr/share/doc/povray/examples"), Path("/usr/share/povray-3.7/include"))
FILES = sorted(f for d in FOLDERS for f in d.rglob("*") if f.suffix in {".pov", ".inc", ".mac", ".map"})
REJECTED_BY_POVRAY = {"__empty.pov"}
"""Found wrong by POV-Ray too."""


def library() -> Library:
    """A library that finds POV-Ray's includes."""
    return Library(FOLDERS[1:])
