"""`minipov diff`: compare two pictures, a scene in both programs, or a folder of scenes.

::

    minipov diff a.png b.png
    minipov diff scene.pov --json
    minipov diff scenes/features --page out/features --tolerance exact
"""

from __future__ import annotations

import argparse
import json
import re
import shlex
import sys
from collections.abc import Sequence
from pathlib import Path

from rich.console import Console

from minipov.compare.metrics import measure, read_picture
from minipov.compare.page import write_page
from minipov.compare.reference import PovrayMissingError
from minipov.compare.survey import Comparison, Plan, find_scenes, survey
from minipov.compare.table import HEADING, as_json, line, print_totals
from minipov.compare.verdict import is_within, judge

WITHIN, BEYOND, MISSING = 0, 1, 2
_PICTURES = frozenset(
    {".png", ".tga", ".ppm", ".pgm", ".bmp", ".jpg", ".jpeg", ".exr", ".hdr", ".tif", ".tiff", ".gif"}
)


def main(arguments: Sequence[str]) -> int:
    """Run ``minipov diff`` and return 0 within the tolerance, 1 beyond it, 2 where a picture is missing."""
    options = _parser().parse_args(arguments)
    try:
        pictures = [path for path in options.paths if path.suffix.lower() in _PICTURES]
        if not pictures:
            return _compare_scenes(options)
        if len(pictures) == len(options.paths) == 2:
            return _compare_pictures(options)
        print("minipov diff: compare two pictures, or scenes and folders", file=sys.stderr)
        return MISSING
    except PovrayMissingError as error:
        print(error, file=sys.stderr)
        return MISSING


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser("minipov diff", description="Compare pictures, or scenes in minipov and POV-Ray.")
    parser.add_argument(
        "paths", nargs="+", type=Path, metavar="PATH", help="two pictures, or scenes and folders of them"
    )
    parser.add_argument("--tolerance", choices=("exact", "close"), default="close", help="what counts as equal enough")
    parser.add_argument("--json", action="store_true", help="print the outcome as JSON")
    parser.add_argument("--page", type=Path, metavar="FOLDER", help="write an HTML page (folders: default out/diff)")
    parser.add_argument(
        "--only", default="*", metavar="GLOB", help="scenes of a folder to compare, by their path in it"
    )
    parser.add_argument("--size", default="160x120", metavar="WxH", type=_size, help="size of the pictures")
    parser.add_argument("--switches", default="", help="further switches for both programs, as '+A0.3 +Q5'")
    parser.add_argument("--timeout", type=float, default=60.0, metavar="S", help="seconds allowed to minipov")
    parser.add_argument(
        "--reference-timeout", type=float, default=240.0, metavar="S", help="seconds allowed to POV-Ray"
    )
    parser.add_argument("--jobs", type=int, default=1, metavar="N", help="scenes at a time")
    parser.add_argument("--fresh", action="store_true", help="render the references again")
    return parser


def _size(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"([1-9]\d*)x([1-9]\d*)", text)
    if match is None:
        raise argparse.ArgumentTypeError(f"'{text}' is no size: give the width and height as in 160x120")
    return int(match[1]), int(match[2])


def _compare_pictures(options: argparse.Namespace) -> int:
    try:
        metrics = measure(*(read_picture(path) for path in options.paths))
    except (OSError, ValueError) as error:
        print(f"minipov diff: {error}", file=sys.stderr)
        return MISSING
    verdict = judge(metrics)
    if options.json:
        names = ("within2", "flip", "mean_error", "ssim")
        print(json.dumps({"verdict": verdict, **{name: getattr(metrics, name) for name in names}}))
    else:
        print(
            f"{verdict}: within2 {metrics.within2:.4f}, FLIP {metrics.flip:.4f}, "
            f"mean error {metrics.mean_error:.3f}, SSIM {metrics.ssim:.4f}"
        )
    return WITHIN if is_within(verdict, options.tolerance) else BEYOND


def _compare_scenes(options: argparse.Namespace) -> int:
    """Compare each named scene, and each in a named folder."""
    console = Console(stderr=options.json, soft_wrap=True, highlight=False)
    single = len(options.paths) == 1 and options.paths[0].is_file()
    page: Path | None = options.page if options.page or single else Path("out/diff")
    width, height = options.size
    plan = Plan(
        width,
        height,
        tuple(shlex.split(options.switches)),
        options.timeout,
        options.reference_timeout,
        options.jobs,
        options.fresh,
        None if page is None else page / "pictures",
    )
    outcomes: list[Comparison] = []
    console.print(HEADING, markup=False)
    for path in options.paths:
        folder = path if path.is_dir() else path.parent
        scenes = find_scenes(path, options.only) if path.is_dir() else [path]
        if not scenes or not path.exists():
            print(f"minipov diff: no scene at {path}", file=sys.stderr)
            return MISSING
        for outcome in survey(scenes, folder, plan):
            outcomes.append(outcome)
            console.print(line(outcome), markup=False)
    if options.json:
        print(json.dumps([as_json(outcome) for outcome in outcomes], indent=1))
    if len(outcomes) > 1:
        print_totals(outcomes, console)
    if page is not None:
        console.print(
            f"The page is {write_page(outcomes, page, f'minipov and POV-Ray: {options.paths[0]}')}", markup=False
        )
    return _status(outcomes, options)


def _status(outcomes: Sequence[Comparison], options: argparse.Namespace) -> int:
    compared = [outcome for outcome in outcomes if outcome.verdict != "no reference"]
    if not compared or any(outcome.verdict == "failed" for outcome in compared):
        return MISSING
    return WITHIN if all(is_within(outcome.verdict, options.tolerance) for outcome in compared) else BEYOND
