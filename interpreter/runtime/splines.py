"""SDL: ``spline { cubic_spline 0, <0,0,0> 1, <1,2,3> }`` and its value ``S(0.5)``.

Outside its range a spline keeps its first or last value; the end points of a cubic (Catmull-Rom) spline only give
directions.
"""

from __future__ import annotations

from bisect import bisect_right
from functools import lru_cache
from typing import Any, Final

from minipov.interpreter.context import Context
from minipov.interpreter.errors import SdlError
from minipov.interpreter.items import Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.interpreter.values import Number, Vector, widened
from minipov.tracer.function import Spline

KINDS: Final = ("linear_spline", "quadratic_spline", "cubic_spline", "natural_spline")
Five = tuple[float, float, float, float, float]


@construct(
    "spline",
    signature="[kind] F, V F, V ...",
    doc="A curve through points, each with the parameter at which the curve is there; S(t) is its point at t.",
    accepts=KINDS,
)
def spline(reader: ItemReader, context: Context, sink: Sink) -> Spline:
    """A spline, or a copy of one with points added."""
    kind: Any = reader.word(*KINDS)
    base = reader.node(Spline)
    kind = kind or reader.word(*KINDS) or (base.kind if base else "linear_spline")
    points: dict[float, Five] = dict(base.points) if base else {}
    size = base.size if base else 1
    while not reader.at_end:
        at = reader.float()
        value = reader.terms("the point of a spline", 5)
        size = max(size, len(value))
        a, b, c, d, e = widened(value, 5)
        points[at] = (a, b, c, d, e)
        reader.comma()
    if not points:
        reader.fail("at least one point: a number and a vector")
    context.messages.warn_once("spline", "splines are an experimental feature of the language", sink.place)
    return Spline(kind, tuple(sorted(points.items())), size)


def evaluate(curve: Spline, at: float, kind: str | None = None) -> Number:
    """The point of ``curve`` at parameter ``at``, as another ``kind`` of spline if one is named."""
    kind = kind or curve.kind
    if kind not in KINDS:
        raise SdlError(f"'{kind}' is no kind of spline", hint=f"kinds: {', '.join(KINDS)}")
    terms = _point(curve, float(at), kind)[: curve.size]
    return terms[0] if curve.size == 1 else Vector(terms)


def _point(curve: Spline, at: float, kind: str) -> tuple[float, ...]:
    parameters, values = _columns(curve)
    last = len(parameters) - 1
    first_valid, last_valid = (1, last - 1) if kind == "cubic_spline" and last >= 3 else (0, last)
    if (kind == "cubic_spline" and last < 3) or last == 0:
        kind = "linear_spline"
    if last == 0 or at <= parameters[first_valid]:
        return values[first_valid]
    if at >= parameters[last_valid]:
        return values[last_valid]
    i = bisect_right(parameters, at) - 1
    if kind == "linear_spline" or (kind != "natural_spline" and last < 2):
        t = (at - parameters[i]) / (parameters[i + 1] - parameters[i])
        return tuple(p + (q - p) * t for p, q in zip(values[i], values[i + 1], strict=True))
    if kind == "quadratic_spline":
        return _quadratic(parameters, values, i, at)
    if kind == "cubic_spline":
        return _cubic(parameters, values, i, at)
    return _natural(curve, i, at)


@lru_cache(maxsize=256)
def _columns(curve: Spline) -> tuple[list[float], list[Five]]:
    return [at for at, _ in curve.points], [value for _, value in curve.points]


def _quadratic(parameters: list[float], values: list[Five], i: int, at: float) -> tuple[float, ...]:
    """Lagrange's parabola through three neighbouring points."""
    i = max(i, 1) if i + 1 < len(parameters) else i - 1
    p, q, r = parameters[i - 1 : i + 2]
    weights = (
        (at - q) * (at - r) / ((p - q) * (p - r)),
        (at - p) * (at - r) / ((q - p) * (q - r)),
        (at - p) * (at - q) / ((r - p) * (r - q)),
    )
    return tuple(
        sum(w * v for w, v in zip(weights, terms, strict=True)) for terms in zip(*values[i - 1 : i + 2], strict=True)
    )


def _cubic(parameters: list[float], values: list[Five], i: int, at: float) -> tuple[float, ...]:
    """Hermite's cubic with Catmull-Rom directions."""
    before, start, end, after = parameters[i - 1 : i + 3]
    step = end - start
    t = (at - start) / step
    h00, h10 = 2 * t**3 - 3 * t**2 + 1, t**3 - 2 * t**2 + t
    h01, h11 = -2 * t**3 + 3 * t**2, t**3 - t**2

    def term(a: float, b: float, c: float, d: float) -> float:
        leaving, arriving = (c - a) / (end - before), (d - b) / (after - start)
        return h00 * b + h10 * step * leaving + h01 * c + h11 * step * arriving

    return tuple(map(term, *values[i - 1 : i + 3]))


def _natural(curve: Spline, i: int, at: float) -> tuple[float, ...]:
    parameters, values = _columns(curve)
    h = parameters[i + 1] - parameters[i]
    a, b = (parameters[i + 1] - at) / h, (at - parameters[i]) / h
    bends = _second_derivatives(curve)

    def term(p: float, q: float, m: float, n: float) -> float:
        return a * p + b * q + ((a**3 - a) * m + (b**3 - b) * n) * h * h / 6

    return tuple(map(term, values[i], values[i + 1], bends[i], bends[i + 1]))


@lru_cache(maxsize=64)
def _second_derivatives(curve: Spline) -> list[tuple[float, ...]]:
    """At every point, so that the curve is smooth and its ends do not bend (a tridiagonal system, term by term)."""
    parameters, values = _columns(curve)
    return list(zip(*(_bends(parameters, [v[k] for v in values]) for k in range(5)), strict=True))


def _bends(x: list[float], y: list[float]) -> list[float]:
    count = len(x)
    upper, right = [0.0] * count, [0.0] * count
    for i in range(1, count - 1):
        left_step, right_step = x[i] - x[i - 1], x[i + 1] - x[i]
        diagonal = 2 * (left_step + right_step) - left_step * upper[i - 1]
        jump = 6 * ((y[i + 1] - y[i]) / right_step - (y[i] - y[i - 1]) / left_step)
        upper[i] = right_step / diagonal
        right[i] = (jump - left_step * right[i - 1]) / diagonal
    bends = [0.0] * count
    for i in range(count - 2, 0, -1):
        bends[i] = right[i] - upper[i] * bends[i + 1]
    return bends
