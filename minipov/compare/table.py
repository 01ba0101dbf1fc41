"""The outcome of a survey on the terminal, and as JSON."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict

from rich.console import Console
from rich.table import Table

from minipov.compare.rendering import Rendering
from minipov.compare.survey import Comparison
from minipov.compare.verdict import VERDICTS, Verdict

_COLORS: dict[Verdict, str] = {"exact": "green", "close": "yellow", "off": "red", "failed": "bold red"}


def totals(comparisons: Sequence[Comparison]) -> dict[Verdict, int]:
    """Count the classes, best first, leaving out those that do not occur."""
    counts: dict[Verdict, int] = {verdict: sum(c.verdict == verdict for c in comparisons) for verdict in VERDICTS}
    return {verdict: count for verdict, count in counts.items() if count}


def line(comparison: Comparison) -> str:
    """Return one scene's outcome in a line."""
    metrics = comparison.metrics
    numbers = f"{metrics.within2:7.4f} {metrics.flip:7.4f} {metrics.ssim:7.4f}" if metrics else " " * 23
    times = f"{_trace(comparison.ours):>8} {_trace(comparison.reference):>8}"
    return f"{comparison.verdict:<12} {numbers} {times}  {comparison.name}  {comparison.message}".rstrip()


HEADING = f"{'class':<12} {'within2':>7} {'FLIP':>7} {'SSIM':>7} {'minipov':>8} {'POV-Ray':>8}  scene (trace seconds)"


def print_totals(comparisons: Sequence[Comparison], console: Console) -> None:
    """Print how many scenes there are of each class, and what that class means."""
    table = Table("class", "scenes", "share", "meaning", box=None)
    for verdict, count in totals(comparisons).items():
        share = f"{100 * count / len(comparisons):.1f} %"
        table.add_row(f"[{_COLORS.get(verdict, 'dim')}]{verdict}[/]", str(count), share, VERDICTS[verdict])
    console.print(table)


def as_json(comparison: Comparison) -> dict[str, object]:
    """Return a comparison as plain values."""
    fields = asdict(comparison)
    for side in ("ours", "reference"):
        if fields[side] is not None:
            fields[side]["picture"] = str(fields[side]["picture"]) if fields[side]["picture"] else None
    return fields


def _trace(made: Rendering | None) -> str:
    return "" if made is None or made.trace_seconds is None else f"{made.trace_seconds:.3f}"
