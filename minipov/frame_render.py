"""One frame: loaded, rendered, written."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from minipov.console import Console
from minipov.diagnostics import not_rendered
from minipov.frames import Frame
from minipov.image_format import FileFormat
from minipov.interpreter import Messages, load, load_text
from minipov.options import CommandLine
from minipov.output_name import output_path
from minipov.pipeline import load_options, start, trace
from minipov.statistics_table import statistics_table
from minipov.tracer.render import RenderJob
from minipov.tracer.scene import Scene
from minipov.tracer.settings import RenderSettings
from minipov.unfinished import Unfinished

ENTRY = "command line"
"""The name of a source that is read in place of the scene: it includes what is wanted before, and the scene."""


@dataclass(frozen=True, slots=True)
class FrameRender:
    """What all frames of a run have in common; calling it with a frame renders that. ``sources`` are texts by name."""

    command: CommandLine
    console: Console
    scene: Path
    sources: dict[str, bytes]
    settings: RenderSettings
    file: FileFormat

    def __call__(self, frame: Frame) -> None:
        """Render a frame.

        Raises:
            SdlError: the scene is wrong.
            OSError: the picture cannot be written.
            KeyboardInterrupt: Ctrl-C; what is finished is written.
        """
        target = self._target(frame)
        self.console.heading("Parsing...")
        started = time.perf_counter()
        graph = self._load(frame)
        load_seconds = time.perf_counter() - started
        self.console.heading("Rendering...")
        state = self._state(target, frame)
        earlier = state.read() if state is not None and self.command.flag("Continue_Trace") else None
        job = start(graph, self.settings, earlier)
        # Loaded while the render goes on.
        from minipov.image_output import write_image

        for feature, place in job.unsupported:
            self.console.warn(not_rendered(feature, place))
        working = graph.settings.assumed_gamma
        try:
            with self.console.progress(self.settings.width * self.settings.height) as progress:
                result = trace(job, _saving(job, state, progress))
        except KeyboardInterrupt:
            if target is not None:
                write_image(target, job.snapshot(), working, self.file)
            if state is not None:
                state.save(job.unfinished())
            raise
        if target is not None:
            write_image(target, result.pixels, working, self.file)
        if state is not None:
            state.remove()
        if self.console.verbose or self.command.flag("Statistics"):
            self.console.say("Statistic", statistics_table(result.statistics, load_seconds))

    def _target(self, frame: Frame) -> Path | Literal["-"] | None:
        """Where the picture goes; whether it can is found out before all the work."""
        if not self.command.flag("Output_to_File"):
            return None
        target = output_path(self.command, self.scene, frame, self.file.kind)
        if target != "-":
            _check_writable(target)
        return target

    def _load(self, frame: Frame) -> Scene:
        options = load_options(self.command, frame, self.sources)
        messages = Messages(sink=self.console.message)
        text = self.sources.get(ENTRY)
        if text is None:
            return load(self.scene, options, messages)
        return load_text(text.decode(), ENTRY, options, messages)

    def _state(self, target: Path | Literal["-"] | None, frame: Frame) -> Unfinished | None:
        if not isinstance(target, Path):
            return None
        content = self.sources.get(str(self.scene)) or self.scene.read_bytes()
        return Unfinished(target, content, frame, self.settings)


def _saving(job: RenderJob, state: Unfinished | None, progress: Callable[[float], None]) -> Callable[[float], None]:
    """Call ``progress``, and save the state of a long render now and then."""

    def report(share: float) -> None:
        progress(share)
        if state is not None and state.is_due:
            state.save(job.unfinished())

    return report


def _check_writable(target: Path) -> None:
    """Raise OSError where a picture cannot be written."""
    if target.is_dir():
        raise IsADirectoryError(21, "is a folder", str(target))
    probe = target.with_name(f".{target.name}.part")
    try:
        probe.touch()
        probe.unlink()
    except OSError as error:
        raise OSError(error.errno, f"cannot be written: {error.strerror}", str(target)) from None
