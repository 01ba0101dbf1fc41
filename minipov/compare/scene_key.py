"""A name for "this scene, rendered this way": what a cached reference picture is filed under.

The key covers the text of the scene, the files beside it that it names in quotes (and what those name in turn), the
switches, and the renderer's version; not the folder the scene lies in, so that every clone shares its references.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator, Sequence
from pathlib import Path

_QUOTED = re.compile(rb'"([^"\n]{1,255})"')
_SDL_SUFFIXES = frozenset({".pov", ".inc", ".mac", ".mcr", ".ini", ".txt"})
_GUESSED_SUFFIXES = ("", ".inc", ".pov", ".png", ".gif", ".tga", ".ttf")


def dependencies(scene: Path) -> Iterator[tuple[str, Path]]:
    """Yield (name as written, file) for the scene and each file beside it that the scene reaches by a quoted name.

    Names put together at run time are not seen.
    """
    folder = scene.parent
    waiting = [(scene.name, scene)]
    seen = {scene}
    while waiting:
        name, file = waiting.pop(0)
        yield name, file
        if file.suffix.lower() not in _SDL_SUFFIXES:
            continue
        for match in _QUOTED.finditer(file.read_bytes()):
            named = match.group(1).decode("utf-8", "replace")
            for suffix in _GUESSED_SUFFIXES:
                found = folder / (named + suffix)
                if found not in seen and found.is_file():
                    seen.add(found)
                    waiting.append((named + suffix, found))


def scene_key(scene: Path, switches: Sequence[str], version: str) -> str:
    """Return a hexadecimal digest of all that decides what the picture looks like."""
    digest = hashlib.sha256()
    for part in (version, *switches):
        digest.update(part.encode() + b"\0")
    for name, file in sorted(dependencies(scene)):
        digest.update(name.encode() + b"\0" + hashlib.sha256(file.read_bytes()).digest())
    return digest.hexdigest()[:32]
