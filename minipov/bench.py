"""``python -m minipov.bench``: trace times of minipov and POV-Ray, side by side, on the scenes of ``scenes/bench``.

Both programs run in turn on the same machine with the same size and threads, each several times; the best time counts,
since everything that disturbs a run makes it slower. ``--json`` prints the numbers for other programs.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from minipov.compare.ours import run_minipov
from minipov.compare.reference import PovrayMissingError, povray_program, run_povray
from minipov.compare.rendering import Rendering

SCENES = Path("scenes/bench")
POVRAYS_OWN = Path("/usr/share/doc/povray/examples/advanced/benchmark/benchmark.pov")
TIMEOUT = 600.0


@dataclass(frozen=True, slots=True)
class Times:
    """Seconds of one program on one scene, the best of several runs; None where it gave no picture."""

    parse: float | None
    trace: float | None


@dataclass(frozen=True, slots=True)
class Measured:
    """Both programs on one scene."""

    scene: str
    povray: Times
    minipov: Times

    @property
    def ratio(self) -> float | None:
        """How many times faster minipov traces."""
        if self.povray.trace is None or not self.minipov.trace:
            return None
        return self.povray.trace / self.minipov.trace


def best(run: Callable[[Path], Rendering], repeats: int) -> Times:
    """Run ``run`` in ``repeats`` fresh folders and return the shortest time of each phase."""
    parse: list[float] = []
    trace: list[float] = []
    for _ in range(repeats):
        with tempfile.TemporaryDirectory(prefix="minipov-bench-") as work:
            rendering = run(Path(work))
        if rendering.trace_seconds is None:
            return Times(None, None)
        # Photons are traced before the picture, but are a part of it.
        trace.append(rendering.trace_seconds + (rendering.photon_seconds or 0.0))
        parse.append(rendering.parse_seconds or 0.0)
    return Times(min(parse), min(trace))


def measure(scene: Path, switches: Sequence[str], repeats: int) -> Measured:
    """Time both programs on ``scene`` with POV-Ray's ``switches``.

    Raises:
        PovrayMissingError: there is nothing to compare with.
    """
    program, scene = povray_program(), scene.resolve()
    povray = best(lambda work: run_povray(program, scene, switches, work, TIMEOUT), repeats)
    minipov = best(lambda work: run_minipov(scene, switches, work, TIMEOUT), repeats)
    return Measured(scene.stem, povray, minipov)


HEADER = f"{'scene':<16}{'POV-Ray':>10}{'minipov':>10}{'ratio':>8}   {'parse':>8}{'parse':>10}"


def row(measured: Measured) -> str:
    """One line of the table; seconds of tracing, how many times faster, seconds of parsing."""

    def seconds(value: float | None) -> str:
        return "-" if value is None else f"{value:.3f}"

    ratio = "-" if measured.ratio is None else f"{measured.ratio:.2f}"
    trace = f"{seconds(measured.povray.trace):>10}{seconds(measured.minipov.trace):>10}{ratio:>8}"
    return f"{measured.scene:<16}{trace}   {seconds(measured.povray.parse):>8}{seconds(measured.minipov.parse):>10}"


def scenes(only: str) -> list[Path]:
    """The benchmark scenes whose names match the glob ``only``; POV-Ray's own last, where it is installed."""
    own = [POVRAYS_OWN] if POVRAYS_OWN.is_file() else []
    return [scene for scene in (*sorted(SCENES.glob("*.pov")), *own) if scene.match(f"{only}.pov")]


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure, print the table, and return the exit status."""
    parser = argparse.ArgumentParser(prog="minipov.bench", description=__doc__)
    parser.add_argument("--threads", type=int, default=1, help="threads of both programs")
    parser.add_argument("--size", default="320x240", metavar="WxH", help="size of the pictures")
    parser.add_argument("--repeats", type=int, default=3, help="runs of which the best counts")
    parser.add_argument("--only", default="*", metavar="GLOB", help="names of the scenes to measure")
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")
    options = parser.parse_args(arguments)
    width, _, height = options.size.partition("x")
    switches = [f"+W{width}", f"+H{height}", f"+WT{options.threads}"]
    results: list[Measured] = []
    try:
        if not options.json:
            print(HEADER)
        for scene in scenes(options.only):
            results.append(measure(scene, switches, options.repeats))
            if not options.json:
                print(row(results[-1]), flush=True)
    except PovrayMissingError as error:
        print(error, file=sys.stderr)
        return 1
    if options.json:
        print(json.dumps([asdict(result) | {"ratio": result.ratio} for result in results], indent=2))
    return 0


if __name__ == "__main__":
    sys.exit(main())
