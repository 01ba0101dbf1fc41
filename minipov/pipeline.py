"""From options to what the interpreter and the tracer ask for, and waiting for a render."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from concurrent.futures import Future
from pathlib import Path
from typing import TYPE_CHECKING

from minipov.frames import Frame
from minipov.include_path import library_folders
from minipov.interpreter.context import Options as LoadOptions
from minipov.options import CommandLine, UsageError
from minipov.tracer.render import RenderJob, RenderResult
from minipov.tracer.scene import Scene
from minipov.tracer.settings import ACCELERATORS, Antialiasing, Gamma, RenderSettings

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from minipov.tracer.image import Image, ImagePurpose

POLL_SECONDS = 0.05
_MAX_PIXELS = 1 << 28


def load_options(command: CommandLine, frame: Frame, files: dict[str, bytes]) -> LoadOptions:
    """Return what the interpreter has to know of the command line."""
    return LoadOptions(
        width=command.integer("Width"),
        height=command.integer("Height"),
        library_paths=(*command.library_paths, *library_folders()),
        declares=command.declares,
        clock=frame.clock,
        clock_on=frame.clock_on,
        clock_delta=frame.clock_delta,
        frame_number=frame.frame_number,
        initial_frame=frame.initial_frame,
        final_frame=frame.final_frame,
        initial_clock=frame.initial_clock,
        final_clock=frame.final_clock,
        version=command.number("Version") if "Version" in command.given else None,
        quality=command.integer("Quality"),
        files=files,
        load_image=load_image_file,
    )


def render_settings(command: CommandLine) -> RenderSettings:
    """Return what the tracer has to know of the command line.

    Raises:
        UsageError: a size, range or name that cannot be.
    """
    width, height = command.integer("Width"), command.integer("Height")
    if width < 1 or height < 1 or width * height > _MAX_PIXELS:
        raise UsageError(f"a picture of {width} by {height} pixels cannot be made")
    method = command.integer("Sampling_Method")
    if method not in (1, 2):
        raise UsageError(f"Sampling_Method={method}: 1 and 2 are possible")
    antialiasing = Antialiasing(
        method=method,
        threshold=command.number("Antialias_Threshold"),
        depth=min(max(command.integer("Antialias_Depth"), 1), 9),
        jitter=command.number("Jitter_Amount") if command.flag("Jitter") else 0.0,
        gamma=command.number("Antialias_Gamma"),
    )
    accelerator = next((name for name in ACCELERATORS if name == command.text("Accelerator")), None)
    if accelerator is None:
        raise UsageError(f"unknown accelerator {command.text('Accelerator')}; there are {', '.join(ACCELERATORS)}")
    return RenderSettings(
        width=width,
        height=height,
        rows=_span(command, "Row", height),
        columns=_span(command, "Column", width),
        antialiasing=antialiasing if command.flag("Antialias") else None,
        quality=min(max(command.integer("Quality"), 0), 11),
        threads=max(command.integer("Work_Threads"), 0),
        alpha=command.flag("Output_Alpha"),
        accelerator=accelerator,
    )


def load_image_file(
    path: Path, kind: str, *, gamma: Gamma, purpose: ImagePurpose, working: Gamma, version: float
) -> Image:
    """Read an image that a scene names; the libraries for that are loaded by the first."""
    from minipov.image_input import load_image

    return load_image(path, kind, gamma=gamma, purpose=purpose, working=working, version=version)


def start(scene: Scene, settings: RenderSettings, earlier: NDArray[np.float32] | None = None) -> RenderJob:
    """Prepare ``scene`` and start rendering; Ctrl-C does not have to wait for the preparations.

    ``earlier`` holds what is finished of the picture, as `RenderJob.unfinished` gave it.
    """
    made: Future[RenderJob] = Future()

    def prepare() -> None:
        try:
            made.set_result(RenderJob(scene, settings, earlier))
        except BaseException as error:
            made.set_exception(error)

    threading.Thread(target=prepare, name="minipov prepare", daemon=True).start()
    return made.result()


def trace(job: RenderJob, progress: Callable[[float], None]) -> RenderResult:
    """Wait for ``job``, calling ``progress`` with the finished share; an exception from there or Ctrl-C cancels it.

    After KeyboardInterrupt the picture so far is in ``job.snapshot()``.
    """
    pause = POLL_SECONDS / 64
    try:
        while not job.finished:
            progress(job.poll())
            time.sleep(pause)
            pause = min(2 * pause, POLL_SECONDS)
        progress(1.0)
        return job.finish()
    except BaseException:
        job.cancel()
        raise


def _span(command: CommandLine, axis: str, size: int) -> tuple[int, int] | None:
    """Rows or columns to render, from 0, the end exclusive; None is all of them."""
    if not {f"Start_{axis}", f"End_{axis}"} & command.given:
        return None
    start, end = command.values[f"Start_{axis}"], command.values[f"End_{axis}"]
    first = int(start * size) if isinstance(start, float) and start <= 1 else int(start) - 1
    last = int(end * size) if isinstance(end, float) and end <= 1 else min(int(end), size)
    if not 0 <= first < last:
        raise UsageError(f"Start_{axis}={start} End_{axis}={end}: nothing of {size} is left to render")
    return first, last
