"""Where POV-Ray keeps its includes, fonts and INI files: found without being told.

An installed POV-Ray names its folders in ``povray.ini`` (``Library_Path=…``); the usual places are looked at as well,
and ``POVINC`` adds folders in front, separated as in PATH.
"""

from __future__ import annotations

import functools
import os
from collections.abc import Iterator
from pathlib import Path

from minipov.ini import read_ini

_DATA_ROOTS = ("/usr/local/share", "/usr/share", "/opt/homebrew/share", "/opt/local/share", "/opt/povray/share")
_INI_ROOTS = ("/usr/local/etc/povray", "/etc/povray", "/opt/homebrew/etc/povray", "/opt/local/etc/povray")
_VERSIONS = ("3.8", "3.7", "3.6")


def startup_ini() -> list[Path]:
    """Return the INI file POV-Ray would read first: ``$POVINI``, ./povray.ini, the user's, or none of them."""
    named = os.environ.get("POVINI")
    places = [Path(named)] if named else []
    places += [Path("povray.ini"), *(Path.home() / ".povray" / version / "povray.ini" for version in _VERSIONS)]
    return next(([place] for place in places if place.is_file()), [])


def library_folders() -> list[Path]:
    """Return the folders to search for includes after those the user gave: POVINC's, then an installed POV-Ray's."""
    named = (Path(part) for part in os.environ.get("POVINC", "").split(os.pathsep) if part)
    return [*named, *standard_folders()]


@functools.cache
def standard_folders() -> tuple[Path, ...]:
    """Return the existing library folders of the POV-Ray installed here, without duplicates."""
    return tuple(dict.fromkeys(folder for folder in _candidates() if folder.is_dir()))


def _candidates() -> Iterator[Path]:
    for root in _INI_ROOTS:
        for version in _VERSIONS:
            yield from _named_in(Path(root) / version / "povray.ini")
    for data in _DATA_ROOTS:
        for version in _VERSIONS:
            for name in (f"povray-{version}", f"povray/{version}", "povray"):
                for part in ("include", "ini", "."):
                    yield Path(data) / name / part
        yield Path(data) / "fonts" / "truetype" / "povray"


def _named_in(ini: Path) -> Iterator[Path]:
    try:
        statements = list(read_ini(ini))
    except OSError:
        return
    for statement in statements:
        if statement.key.lower() == "library_path":
            yield Path(statement.value)
