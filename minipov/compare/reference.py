"""POV-Ray's picture of a scene: run the program once, remember what it made (or that it could not).

References live in ``~/.cache/minipov/references`` (``$XDG_CACHE_HOME`` is honoured): a ``.png`` and a ``.json`` each.
"""

from __future__ import annotations

import functools
import json
import os
import re
import shutil
import subprocess
import tempfile
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Literal

from platformdirs import user_cache_path

from minipov.compare.scene_key import scene_key

INSTALL_HINT = (
    "POV-Ray is needed for the reference pictures and was not found.\n"
    "Debian, Ubuntu: apt-get install povray povray-includes povray-examples\n"
    "Fedora: dnf install povray   macOS: brew install povray   (or set POVRAY_BINARY)"
)
Status = Literal["rendered", "failed", "timeout"]
_TIMES = {name: re.compile(name + r" Time:.*?\(([\d.]+) seconds\)") for name in ("Parse", "Photon", "Trace")}


class PovrayMissingError(Exception):
    """No POV-Ray program on this machine."""

    def __init__(self) -> None:
        super().__init__(INSTALL_HINT)


@dataclass(frozen=True, slots=True)
class Reference:
    """What POV-Ray did with a scene. ``seconds`` is wall time; the other times are what the program printed.

    ``picture`` is a file in the cache, None unless ``status`` is "rendered"; ``message`` then says why.
    """

    status: Status
    seconds: float
    parse_seconds: float | None = None
    photon_seconds: float | None = None
    trace_seconds: float | None = None
    message: str = ""
    picture: Path | None = None


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


def reference(scene: Path, switches: Sequence[str], timeout: float = 240.0, *, fresh: bool = False) -> Reference:
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
        made = run_povray(program, scene, switches, Path(work), timeout)
        return _remember(key, made)


def run_povray(program: str, scene: Path, switches: Sequence[str], work: Path, timeout: float) -> Reference:
    """Run POV-Ray in the empty folder ``work``, where its picture and all files that the scene writes end up."""
    picture = work / "picture.png"
    command = [program, f"+I{scene}", f"+O{picture}", f"+L{scene.parent}", "-D", "-P", "-A", "+WT1", *switches]
    started = time.perf_counter()
    log = work / "povray.log"
    try:
        with log.open("wb") as sink:
            done = subprocess.run(
                command, cwd=work, stdin=subprocess.DEVNULL, stdout=sink, stderr=sink, timeout=timeout, check=False
            )
    except subprocess.TimeoutExpired:
        return Reference("timeout", time.perf_counter() - started, message=f"no picture after {timeout:g} s")
    seconds = time.perf_counter() - started
    said = log.read_text("utf-8", "replace")
    if done.returncode != 0 or not picture.is_file():
        return Reference("failed", seconds, message=_complaint(said))
    parse, photon, trace = (_time(said, name) for name in _TIMES)
    return Reference("rendered", seconds, parse, photon, trace, picture=picture)


def _time(said: str, name: str) -> float | None:
    match = _TIMES[name].search(said)
    return float(match.group(1)) if match else None


def _complaint(said: str) -> str:
    """Return the line of POV-Ray's output that tells what went wrong."""
    lines = [line.strip() for line in said.splitlines() if line.strip()]
    telling = [line for line in lines if "Error:" in line or line.startswith("Problem with")]
    return (telling or lines or ["no output"])[-1][:300]


def _recall(key: str) -> Reference | None:
    note, picture = cache_folder() / f"{key}.json", cache_folder() / f"{key}.png"
    try:
        known = json.loads(note.read_text())
        found = Reference(**(known | {"picture": picture if known["status"] == "rendered" else None}))
    except (OSError, ValueError, TypeError, KeyError):
        return None
    return None if found.status == "rendered" and not picture.is_file() else found


def _remember(key: str, made: Reference) -> Reference:
    """File the outcome; the note goes last and into place at once, so that an interrupted run leaves no half entry."""
    folder = cache_folder()
    folder.mkdir(parents=True, exist_ok=True)
    note, picture = folder / f"{key}.json", folder / f"{key}.png"
    kept = None
    if made.picture is not None:
        with tempfile.NamedTemporaryFile(dir=folder, suffix=".part", delete=False) as part:
            part.write(made.picture.read_bytes())
        Path(part.name).replace(picture)
        kept = picture
    fields = asdict(made) | {"picture": None}
    with tempfile.NamedTemporaryFile("w", dir=folder, suffix=".part", delete=False) as text:
        json.dump(fields, text)
    Path(text.name).replace(note)
    return Reference(**(fields | {"picture": kept}))
