"""Comparing scenes: both programs render each, the pictures are measured and judged."""

from __future__ import annotations

import fnmatch
import shutil
import tempfile
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from pathlib import Path

from minipov.compare.difference import write_difference
from minipov.compare.header import read_header
from minipov.compare.metrics import Metrics, measure, read_picture
from minipov.compare.ours import run_minipov
from minipov.compare.reference import reference
from minipov.compare.rendering import Rendering
from minipov.compare.verdict import Verdict, judge

OURS, REFERENCE, DIFFERENCE = "minipov", "povray", "difference"


@dataclass(frozen=True, slots=True)
class Plan:
    """How scenes are rendered: size, further switches, seconds allowed to each program, scenes at a time.

    ``pictures`` is where both pictures and their difference are kept; None throws them away.
    """

    width: int = 160
    height: int = 120
    switches: tuple[str, ...] = ()
    timeout: float = 60.0
    reference_timeout: float = 240.0
    jobs: int = 1
    fresh: bool = False
    pictures: Path | None = None


@dataclass(frozen=True, slots=True)
class Comparison:
    """One scene's outcome. ``name`` is its path below the compared folder, without ``.pov``."""

    name: str
    verdict: Verdict
    expected: Verdict | None = None
    title: str = ""
    metrics: Metrics | None = None
    ours: Rendering | None = None
    reference: Rendering | None = None
    message: str = field(default="")


def find_scenes(folder: Path, pattern: str = "*") -> list[Path]:
    """Return the scenes below ``folder`` whose path from there, with or without ``.pov``, matches ``pattern``.

    A scene's suffix may be in capitals, as old systems have it.
    """
    scenes = sorted(path for path in folder.rglob("*") if path.suffix.lower() == ".pov")
    names = {scene: scene.relative_to(folder) for scene in scenes}
    return [
        scene
        for scene, name in names.items()
        if fnmatch.fnmatch(str(name), pattern) or fnmatch.fnmatch(str(name.with_suffix("")), pattern)
    ]


def survey(scenes: Sequence[Path], folder: Path, plan: Plan) -> Iterator[Comparison]:
    """Compare ``scenes``, yielding each as it is done, in order. Raises PovrayMissingError."""
    with ThreadPoolExecutor(max(plan.jobs, 1)) as pool:
        yield from pool.map(lambda scene: compare_scene(scene, _name(scene, folder), plan), scenes)


def compare_scene(scene: Path, name: str, plan: Plan) -> Comparison:
    """Render ``scene`` in both programs and compare. Raises PovrayMissingError."""
    header = read_header(scene)
    switches = (f"+W{plan.width}", f"+H{plan.height}", *header.switches, *plan.switches)
    expected = reference(scene, switches, plan.reference_timeout, fresh=plan.fresh)
    with tempfile.TemporaryDirectory(prefix="minipov-compare-") as work:
        made = run_minipov(scene, switches, Path(work), plan.timeout)
        verdict, metrics, message = _judge(made, expected)
        if plan.pictures is not None:
            _keep_pictures(made, expected, name, plan.pictures)
    return Comparison(name, verdict, header.expected, header.title, metrics, _apart(made), _apart(expected), message)


def picture_name(name: str, side: str) -> str:
    """Return the file name of one of a scene's three kept pictures: `OURS`, `REFERENCE` or `DIFFERENCE`."""
    return f"{name.replace('/', '_')}-{side}.png"


def _judge(made: Rendering, expected: Rendering) -> tuple[Verdict, Metrics | None, str]:
    if expected.picture is None:
        # A scene that keeps POV-Ray busy beyond its time may keep us busy too.
        hangs = made.status == "timeout" and expected.status != "timeout"
        crashed = hangs or "signal" in made.message
        return ("failed", None, made.message) if crashed else ("no reference", None, expected.message)
    if made.picture is None:
        return "failed", None, made.message
    try:
        metrics = measure(read_picture(made.picture), read_picture(expected.picture))
    except (OSError, ValueError) as error:
        return "failed", None, str(error)
    return judge(metrics), metrics, "; ".join(dict.fromkeys(made.warnings))[:300]


def _keep_pictures(made: Rendering, expected: Rendering, name: str, folder: Path) -> None:
    """Put the pictures there are, and their difference, where they stay; those of an earlier survey go."""
    folder.mkdir(parents=True, exist_ok=True)
    for side, rendering in ((OURS, made), (REFERENCE, expected)):
        kept = folder / picture_name(name, side)
        kept.unlink(missing_ok=True)
        if rendering.picture is not None:
            shutil.copyfile(rendering.picture, kept)
    difference = folder / picture_name(name, DIFFERENCE)
    difference.unlink(missing_ok=True)
    if made.picture is not None and expected.picture is not None:
        write_difference(made.picture, expected.picture, difference)


def _apart(made: Rendering) -> Rendering:
    """Forget where the picture was: it is gone, or belongs to the cache."""
    return replace(made, picture=None)


def _name(scene: Path, folder: Path) -> str:
    return str(scene.relative_to(folder).with_suffix("")) if scene.is_relative_to(folder) else scene.stem
