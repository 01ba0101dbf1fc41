"""POV-Ray's picture of a scene: run the program once, remember what it made (or that it could not).

References live in the user's cache folder, ``~/.cache/minipov/references`` on Linux: a ``.png`` and a ``.json`` each.
"""

from __future__ import annotations

import functools
import json
import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import asdict, replace
from pathlib import Path

from platformdirs import user_cache_path

from minipov.compare.rendering import PICTURE, Rendering, run_renderer
from minipov.compare.scene_key import scene_key

INSTALL_HINT = (
    "POV-Ray is needed for the reference pictures and was not found.\n"
    "Debian, Ubuntu: apt-get install povray povray-includes povray-examples\n"
    "Fedora: dnf install povray   macOS: brew install povray   (or set POVRAY_BINARY)"
)


class PovrayMissingError(Exception):
    """No POV-Ray program on this machine."""

    def __init__(self) -> None:
        super().__init__(INSTALL_HINT)


def povray_program() -> str:
    """Return the path of POV-Ray (``POVRAY_BINARY``, else ``povray`` on the PATH) or raise PovrayMissingError."""
    program = shutil.which(os.environ.get("POVRAY_BINARY", "povray"))
    if program is None:
        raise PovrayMissingError
    return program


@functools.cache
def povray_version(program: str) -> str:
    """Return what the program says it is, for instance ``POV-Ray 3.7.0.10.unofficial``."""
    said = subprocess.run([program, "--version"], capture_output=True, text=True, timeout=60, check=False)
    match = re.search(r"POV-Ray [\d.]+\S*", said.stdout + said.stderr)
    return match.group(0) if match else "POV-Ray"


def cache_folder() -> Path:
    """Return the folder of the references."""
    return user_cache_path("minipov") / "references"


def reference(scene: Path, switches: Sequence[str], timeout: float = 240.0, *, fresh: bool = False) -> Rendering:
    """Return POV-Ray's rendering of ``scene``, from the cache where it is there.

    ``switches`` are those that change the picture (size, anti-aliasing, quality). ``fresh`` renders again. A timeout is
    remembered, and tried again only when more time is given. Raises PovrayMissingError.
    """
    program = povray_program()
    scene = scene.resolve()
    key = scene_key(scene, switches, povray_version(program))
    known = None if fresh else _recall(key)
    if known is not None and not (known.status == "timeout" and known.seconds + 1 < timeout):
        return known
    with tempfile.TemporaryDirectory(prefix="minipov-reference-") as work:
        return _remember(key, run_povray(program, scene, switches, Path(work), timeout))


def run_povray(program: str, scene: Path, switches: Sequence[str], work: Path, timeout: float) -> Rendering:
    """Run POV-Ray in the empty folder ``work``, where its picture and all files that the scene writes end up."""
    command = [
        program,
        f"+I{_word(scene)}",
        f"+O{PICTURE}",
        f"+L{_word(scene.parent)}",
        "-D",
        "-P",
        "-A",
        "+WT1",
        *switches,
    ]
    return run_renderer(command, work, timeout)


def _word(path: Path) -> str:
    """A path as POV-Ray takes it in one piece: its switches end at a blank that is not in quotes."""
    return f'"{path}"' if " " in str(path) else str(path)


def _recall(key: str) -> Rendering | None:
    note, picture = cache_folder() / f"{key}.json", cache_folder() / f"{key}.png"
    try:
        known = json.loads(note.read_text())
        found = Rendering(**(known | {"warnings": (), "picture": picture if known["status"] == "rendered" else None}))
    except (OSError, ValueError, TypeError, KeyError):
        return None
    return None if found.status == "rendered" and not picture.is_file() else found


def _remember(key: str, made: Rendering) -> Rendering:
    """File the outcome; the note goes last, and both into place at once: an interrupted run leaves no half entry."""
    folder = cache_folder()
    folder.mkdir(parents=True, exist_ok=True)
    note, picture = folder / f"{key}.json", folder / f"{key}.png"
    if made.picture is not None:
        _put(picture, made.picture.read_bytes())
    _put(note, json.dumps(asdict(made) | {"warnings": (), "picture": None}).encode())
    return replace(made, picture=None if made.picture is None else picture)


def _put(path: Path, content: bytes) -> None:
    with tempfile.NamedTemporaryFile(dir=path.parent, suffix=".part", delete=False) as part:
        part.write(content)
    Path(part.name).replace(path)
