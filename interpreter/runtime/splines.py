"""SDL: ``spline { cubic_spline 0, <0,0,0> 1, <1,2,3> }`` and its value ``S(0.5)``.

Outside its range a spline keeps its first or last value; the end points of a cubic (Catmull-Rom) spline only give
directions.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any, Final

from minipov.interpreter.context import Context
from minipov.interpreter.errors import SdlError
from minipov.interpreter.items import Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.interpreter.values import Number, Vector
from minipov.tracer import _core
from minipov.tracer.function import Spline, SplineFunction
from minipov.tracer.node import replace

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
    kind: Any = reader.word_of(KINDS)
    base = reader.node(Spline)
    kind = kind or reader.word_of(KINDS) or (base.kind if base else "linear_spline")
    points: dict[float, Five] = dict(base.points) if base else {}
    size = base.size if base else 2
    last: tuple[float, ...] = (0.0,) * 5
    while not reader.at_end:
        at = reader.float()
        value = reader.terms("the point of a spline", 5)
        if len(value) == 1:
            value = (*value, *value)
        size = max(size, len(value))
        # What a point does not say is as in the point before it: so POV-Ray has it.
        a, b, c, d, e = last = (*value, *last[len(value) :])
        points[at] = (a, b, c, d, e)
        reader.comma()
    if not points:
        reader.fail("at least one point: a number and a vector")
    context.messages.warn_once("spline", "splines are an experimental feature of the language", sink.place)
    return Spline(kind, tuple(sorted(points.items())), size)


def evaluate(curve: Spline, at: float, kind: str | None = None) -> Number:
    """The point of ``curve`` at parameter ``at``, as another ``kind`` of spline if one is named."""
    if kind is not None and kind not in KINDS:
        raise SdlError(f"'{kind}' is no kind of spline", hint=f"kinds: {', '.join(KINDS)}")
    value = _compiled(curve, kind)(float(at))
    return Vector(value) if isinstance(value, tuple) else value


@lru_cache(maxsize=256)
def _compiled(curve: Spline, kind: Any) -> _core.Function:
    return _core.Function(SplineFunction(curve if kind is None else replace(curve, kind=kind)))
