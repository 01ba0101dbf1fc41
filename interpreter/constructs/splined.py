"""SDL: shapes from a spline: ``lathe``, ``sor``, ``prism``, ``sphere_sweep``."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, Literal

from minipov.interpreter.constructs.common import bulk, number, read_fields
from minipov.interpreter.constructs.rings import open_ring_start
from minipov.interpreter.constructs.shape import shape
from minipov.interpreter.context import Context
from minipov.interpreter.reader import ItemReader
from minipov.tracer.objects import Shape
from minipov.tracer.shapes import Lathe, Prism, Sor, SphereSweep, SplineKind
from minipov.tracer.values import Vec2, Vec3

CURVES: Final[tuple[SplineKind, ...]] = ("linear_spline", "quadratic_spline", "cubic_spline", "bezier_spline")
SWEEP_CURVES: Final[tuple[SplineKind, ...]] = ("linear_spline", "b_spline", "cubic_spline")
LATHE_POINTS: Final[dict[SplineKind, int]] = {
    "linear_spline": 2,
    "quadratic_spline": 3,
    "cubic_spline": 4,
    "bezier_spline": 4,
}
PRISM_POINTS: Final[dict[SplineKind, int]] = {
    "linear_spline": 3,
    "quadratic_spline": 5,
    "cubic_spline": 6,
    "bezier_spline": 4,
}
SWEEP_POINTS: Final[dict[SplineKind, int]] = {"linear_spline": 2, "b_spline": 4, "cubic_spline": 4}


def _kind(reader: ItemReader, kinds: tuple[SplineKind, ...]) -> SplineKind | None:
    word = reader.word_of(kinds)
    return next((kind for kind in kinds if kind == word), None)


def _count(reader: ItemReader, kind: SplineKind, least: dict[SplineKind, int]) -> int:
    count = reader.integer()
    if count < least[kind]:
        reader.refuse(f"at least {least[kind]} points for a {kind}")
    if kind == "bezier_spline" and count % 4:
        reader.refuse("four points for each piece of a bezier_spline")
    return count


def _points(reader: ItemReader, count: int) -> tuple[Vec2, ...]:
    return tuple((a, b) for a, b in bulk(reader, count, 2, "points").tolist())


@shape(
    "lathe",
    signature="[spline type] count, point, point, ... [sturm]",
    doc="A curve in the xy-plane, turned about the y axis.",
    accepts=(*CURVES, "sturm"),
)
def lathe(reader: ItemReader, context: Context) -> Shape:
    kind = _kind(reader, CURVES) or "linear_spline"
    return Lathe(kind, _points(reader, _count(reader, kind, LATHE_POINTS)))


@shape(
    "sor",
    signature="count, point, point, ... [open] [sturm]",
    doc="A surface of revolution about the y axis; the first and last points only steer the slope.",
    accepts=("open", "sturm"),
)
def sor(reader: ItemReader, context: Context) -> Shape:
    count = reader.integer()
    if count < 4:
        reader.refuse("at least 4 points")
    points = _points(reader, count)
    if not all(_has_outline(points[at : at + 4]) for at in range(count - 3)):
        reader.refuse("points of rising height and of radius 0 or more")
    return Sor(points)


def _has_outline(points: Sequence[Vec2]) -> bool:
    """Whether there is a piece of a surface of revolution between the second and third of four points."""
    (before, y0), (low, y1), (high, y2), (_, y3) = points
    return min(before, low, high) >= 0.0 and y1 < y2 and y0 != y2 and y1 != y3


SWEEPS: Final[tuple[Literal["linear_sweep", "conic_sweep"], ...]] = ("linear_sweep", "conic_sweep")


@shape(
    "prism",
    signature="[spline type] [linear_sweep|conic_sweep] height, height, count, point, ... [open] [sturm]",
    doc="A curve in the xz-plane, moved along y; conic_sweep narrows it towards the origin.",
    accepts=(*CURVES, *SWEEPS, "open", "sturm"),
)
def prism(reader: ItemReader, context: Context) -> Shape:
    place = reader.place
    kind: SplineKind = "linear_spline"
    sweep = SWEEPS[0]
    while True:
        curve = _kind(reader, CURVES)
        if curve is not None:
            kind = curve
            continue
        word = reader.word_of(SWEEPS)
        if word is None:
            break
        sweep = "conic_sweep" if word == "conic_sweep" else "linear_sweep"
    low, high = reader.float(), reader.float()
    points = _points(reader, _count(reader, kind, PRISM_POINTS))
    start = open_ring_start(points) if kind == "linear_spline" else None
    if start is not None:
        context.messages.warn("linear prism is not closed: closed for you", place)
        points = (*points, start)
    return Prism(kind, sweep, low, high, points)


@shape(
    "sphere_sweep",
    signature="linear_spline|b_spline|cubic_spline count, center, radius, ... [tolerance F]",
    doc="What a ball of changing size covers on its way along a curve.",
    accepts=(*SWEEP_CURVES, "tolerance"),
)
def sphere_sweep(reader: ItemReader, context: Context) -> Shape:
    kind = _kind(reader, SWEEP_CURVES)
    if kind is None:
        reader.fail("linear_spline, b_spline or cubic_spline")
    spheres: list[tuple[Vec3, float]] = []
    for _ in range(_count(reader, kind, SWEEP_POINTS)):
        center = reader.vector()
        spheres.append((center, reader.float()))
    said = read_fields(reader, {"tolerance": number("tolerance")}) or {}
    return SphereSweep(kind, tuple(spheres), **said)
