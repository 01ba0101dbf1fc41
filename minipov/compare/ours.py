"""minipov's picture of a scene, made in a process of its own so that no scene can stop the comparison.

The processes are forked from a server that has minipov loaded: a scene does not pay for starting Python.
"""

from __future__ import annotations

import functools
import multiprocessing
import os
import sys
import time
from collections.abc import Sequence
from multiprocessing.context import BaseContext
from pathlib import Path

from minipov.compare.rendering import LOG, PICTURE, Rendering, outcome, timed_out

_PRELOADED = ["minipov.job", "minipov.image_input", "minipov.image_output"]


def run_minipov(scene: Path, switches: Sequence[str], work: Path, timeout: float) -> Rendering:
    """Render ``scene`` with POV-Ray's ``switches`` in the empty folder ``work``."""
    scene = scene.resolve()
    options = [f"+I{scene}", f"+O{PICTURE}", f"+L{scene.parent}", "--statistics", "-A", "+WT1", *switches]
    started = time.perf_counter()
    process = _processes().Process(target=_render, args=(options, work), daemon=True)  # type: ignore[attr-defined]
    process.start()
    try:
        process.join(timeout)
        if process.is_alive():
            return timed_out(time.perf_counter() - started, timeout)
        return outcome(work, process.exitcode, time.perf_counter() - started)
    finally:
        process.kill()
        process.join()


@functools.cache
def _processes() -> BaseContext:
    """The way to start processes: from a server where there are forks."""
    if "forkserver" not in multiprocessing.get_all_start_methods():
        return multiprocessing.get_context("spawn")
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(_PRELOADED)
    return context


def _render(options: Sequence[str], work: Path) -> None:
    """Be `minipov` for one scene: in ``work``, with all that is said going to its log."""
    os.chdir(work)
    with Path(LOG).open("wb") as log, Path(os.devnull).open("rb") as nothing:
        for stream, target in ((nothing, 0), (log, 1), (log, 2)):
            os.dup2(stream.fileno(), target)
    from minipov.cli import main

    sys.exit(main(options))
