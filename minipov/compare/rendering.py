"""One program's attempt at a scene: run it in a folder of its own, see what it made and what it said."""

from __future__ import annotations

import re
import subprocess
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

Status = Literal["rendered", "failed", "timeout"]
PICTURE, LOG = "picture.png", "messages.txt"
_TIMES = {name: re.compile(name + r" Time:.*?\(([\d.]+) seconds\)") for name in ("Parse", "Photon", "Trace")}


@dataclass(frozen=True, slots=True)
class Rendering:
    """What a program did with a scene. ``seconds`` is wall time; the other times are what the program printed.

    ``picture`` is None unless ``status`` is "rendered"; ``message`` then says why. ``warnings`` are the program's.
    """

    status: Status
    seconds: float
    parse_seconds: float | None = None
    photon_seconds: float | None = None
    trace_seconds: float | None = None
    message: str = ""
    warnings: tuple[str, ...] = ()
    picture: Path | None = None


def run_renderer(command: Sequence[str], work: Path, timeout: float) -> Rendering:
    """Run ``command`` in the folder ``work``, in which it has to leave `PICTURE` and may leave other files."""
    log = work / LOG
    started = time.perf_counter()
    try:
        with log.open("wb") as sink:
            done = subprocess.run(
                command, cwd=work, stdin=subprocess.DEVNULL, stdout=sink, stderr=sink, timeout=timeout, check=False
            )
    except subprocess.TimeoutExpired:
        return timed_out(time.perf_counter() - started, timeout)
    return outcome(work, done.returncode, time.perf_counter() - started)


def outcome(work: Path, status: int, seconds: float) -> Rendering:
    """Read what a program that ended with ``status`` left in ``work``: `PICTURE` and `LOG`."""
    log, picture = work / LOG, work / PICTURE
    said = log.read_text("utf-8", "replace") if log.is_file() else ""
    if status != 0 or not picture.is_file():
        return Rendering("failed", seconds, message=complaint(said, status))
    parse, photon, trace = (printed_time(said, name) for name in _TIMES)
    warnings = tuple(line for line in said.splitlines() if "warning:" in line)
    return Rendering("rendered", seconds, parse, photon, trace, warnings=warnings, picture=picture)


def timed_out(seconds: float, timeout: float) -> Rendering:
    """Say that a program was stopped."""
    return Rendering("timeout", seconds, message=f"no picture after {timeout:g} s")


def printed_time(said: str, name: str) -> float | None:
    """Return the seconds of a phase ("Parse", "Photon", "Trace") as both programs print them."""
    match = _TIMES[name].search(said)
    return float(match.group(1)) if match else None


def complaint(said: str, status: int) -> str:
    """Return the line of a program's output that tells best what went wrong."""
    lines = [line.strip() for line in said.splitlines() if line.strip()]
    if status < 0:
        return f"killed by signal {-status}"
    for telling in ("Traceback", "error: ", "Error: ", "Problem with"):
        found = [line for line in lines if telling in line]
        if telling == "Traceback" and found:
            return lines[-1][:300]
        if found:
            return found[0][:300]
    return (lines or [f"exit status {status} and no message"])[-1][:300]
