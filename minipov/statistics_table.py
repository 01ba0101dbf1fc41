"""`minipov --statistics`: what a render counted, as a table."""

from __future__ import annotations

from minipov.tracer.render import Statistics


def statistics_table(counted: Statistics, load_seconds: float) -> str:
    """Return rays by kind, tests by shape, boxes and cells looked at per ray, and times."""
    rays = sum(counted.rays.values())
    lines = [f"{'Rays':<34}{rays:>14,}"]
    lines += [f"  {kind:<32}{number:>14,}" for kind, number in counted.rays.items() if number]
    tests = sum(counted.tests.values())
    lines.append(f"{'Object tests':<34}{tests:>14,}{tests / max(rays, 1):>10.2f} per ray")
    lines += [f"  {shape:<32}{number:>14,}" for shape, number in sorted(counted.tests.items()) if number]
    for name, number in (("Boxes tested", counted.boxes), ("Cells visited", counted.cells)):
        lines.append(f"{name:<34}{number:>14,}{number / max(rays, 1):>10.2f} per ray")
    lines.append(f"{'Inside tests':<34}{counted.inside_tests:>14,}")
    for name, seconds in (
        ("Parse Time", load_seconds),
        ("Prepare Time", counted.prepare_seconds),
        ("Trace Time", counted.trace_seconds),
    ):
        lines.append(f"{name + ':':<34}{seconds:>14.3f} seconds ({seconds:.3f} seconds)")
    return "\n".join(lines)
