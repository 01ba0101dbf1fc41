"""Rendering a scene: `render` waits for the picture, `RenderJob` lets the caller look on, take snapshots and cancel.

>>> from minipov.tracer.render import render
>>> from minipov.tracer.scene import Scene
>>> from minipov.tracer.settings import RenderSettings
>>> render(Scene(), RenderSettings(width=4, height=3)).pixels.shape
(3, 4, 4)
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping

import numpy as np
from minipov.tracer import _core
from minipov.tracer.node import node
from minipov.tracer.scene import Scene
from minipov.tracer.settings import RenderSettings
from numpy.typing import NDArray

POLL_SECONDS = 0.05


@node(eq=False)
class Statistics:
    """What a render counted: ``rays`` by kind, primitive ``tests`` by shape, search ``cells`` and ``boxes`` looked at,
    tests for being inside, and seconds of preparing and tracing."""

    rays: Mapping[str, int]
    tests: Mapping[str, int]
    cells: int
    boxes: int
    inside_tests: int
    prepare_seconds: float
    trace_seconds: float


@node(eq=False)
class RenderResult:
    """A picture: ``pixels`` (height, width, 4), float32, row 0 at the top.

    Colours are linear in the scene's working space, not limited to 0..1, and stand against black (alpha is already
    multiplied in). ``unsupported`` lists what the scene asks for and the core leaves out, with its place in the source.
    ``complete`` is False after a cancel.
    """

    pixels: NDArray[np.float32]
    statistics: Statistics
    unsupported: list[tuple[str, str]]
    complete: bool


class RenderJob:
    """A render that runs on its own threads."""

    def __init__(self, scene: Scene, settings: RenderSettings, earlier: NDArray[np.float32] | None = None) -> None:
        """Prepare the scene and start, or go on from what `unfinished` gave for the same scene.

        Raises:
            ValueError: ``earlier`` has another size.
        """
        self._job = _core.RenderJob(scene, settings, earlier)

    def poll(self) -> float:
        """The finished share of the picture, 0 to 1."""
        done, total = self._job.progress()
        return done / total if total else 1.0

    @property
    def finished(self) -> bool:
        """Whether the render has ended, by itself or by `cancel`."""
        return self._job.is_finished()

    @property
    def unsupported(self) -> list[tuple[str, str]]:
        """What the scene asks for and the core leaves out: feature and place; known from the start."""
        return self._job.unsupported()

    def cancel(self) -> None:
        """Ask the render to stop soon."""
        self._job.cancel()

    def snapshot(self) -> NDArray[np.float32]:
        """The pixels so far, as in `RenderResult`; zeros where nothing is finished."""
        return self._job.snapshot()

    def unfinished(self) -> NDArray[np.float32]:
        """The pixels so far, NaN where nothing is finished."""
        return self._job.unfinished()

    def finish(self) -> RenderResult:
        """Wait for the end.

        Raises:
            RuntimeError: the core failed.
        """
        self._job.wait()
        statistics = Statistics(**self._job.statistics())  # type: ignore[arg-type]  # the core counts just these
        return RenderResult(self._job.snapshot(), statistics, self._job.unsupported(), self.poll() == 1.0)


def render(scene: Scene, settings: RenderSettings, progress: Callable[[float], object] | None = None) -> RenderResult:
    """Render a scene, calling ``progress`` with the finished share now and then; an exception from it cancels.

    Raises:
        RuntimeError: the core failed.
    """
    job = RenderJob(scene, settings)
    try:
        while progress is not None and not job.finished:
            progress(job.poll())
            time.sleep(POLL_SECONDS)
        return job.finish()
    except BaseException:
        job.cancel()
        raise
