"""SDL: shapes from a field or formula: ``isosurface``, ``parametric``, ``julia_fractal``."""

from __future__ import annotations

from typing import Any, Final

from minipov.interpreter.constructs.common import Field, count, number, read_fields, switch
from minipov.interpreter.constructs.patterns import FUNCTION_TYPES
from minipov.interpreter.constructs.shape import shape
from minipov.interpreter.context import Context
from minipov.interpreter.items import Block, Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.function import Function
from minipov.tracer.objects import Object, Shape
from minipov.tracer.shapes import Box, Isosurface, JuliaFractal, Parametric, Sphere
from minipov.tracer.values import Vec2, Vec3

MOST_HITS: Final = 10
MOST_PRECOMPUTED: Final = 20


def read_function(reader: ItemReader) -> Function:
    """A function, after an optional comma."""
    reader.comma()
    function = reader.node(FUNCTION_TYPES)
    if function is None:
        reader.fail("a function { ... }")
    return function


@construct(
    "contained_by",
    signature="sphere { } | box { }",
    doc="The container outside of which the surface is not looked for.",
    accepts=("sphere", "box"),
)
def contained_by(reader: ItemReader, context: Context, sink: Sink) -> Block:
    thing = reader.node(Object)
    if thing is None or not isinstance(thing.shape, Sphere | Box):
        reader.fail("a sphere or a box")
    return Block("contained_by", thing.shape)


def _read_parameters(reader: ItemReader, table: dict[str, Field]) -> dict[str, Any]:
    """Fields of ``table`` and ``contained_by``, up to the first other item."""
    said: dict[str, Any] = {}
    while True:
        fields = read_fields(reader, table)
        if fields is not None:
            said.update(fields)
            continue
        container = reader.block("contained_by")
        if container is None:
            return said
        said["contained_by"] = container


def _evaluate(reader: ItemReader) -> Vec3:
    """Three numbers: the least gradient, by how much what is found is overestimated, how fast that is forgotten."""
    least = reader.float()
    reader.comma()
    overestimation = reader.float()
    reader.comma()
    return (least, overestimation, reader.float())


ISOSURFACE_FIELDS: Final[dict[str, Field]] = {
    "threshold": number("threshold"),
    "accuracy": number("accuracy"),
    "max_gradient": number("max_gradient"),
    "evaluate": lambda reader: {"evaluate": _evaluate(reader)},
    "open": switch("open"),
    "max_trace": lambda reader: {"max_trace": min(max(reader.integer(), 1), MOST_HITS)},
    "all_intersections": lambda reader: {"max_trace": MOST_HITS, "all_intersections": True},
    "polarity": lambda reader: {"polarity": reader.float() > 0.0},
}


@shape(
    "isosurface",
    signature="function {} [contained_by {}] [threshold F] [accuracy F] [max_gradient F] ...",
    doc="Where a function of x, y, z has the value of the threshold; smaller values are inside.",
    accepts=("function", "contained_by", *ISOSURFACE_FIELDS),
)
def isosurface(reader: ItemReader, context: Context) -> Shape:
    function = read_function(reader)
    return Isosurface(function, **_read_parameters(reader, ISOSURFACE_FIELDS))


def _precompute(reader: ItemReader) -> dict[str, Any]:
    depth = reader.integer()
    if not 1 <= depth <= MOST_PRECOMPUTED:
        reader.refuse(f"a precompute depth from 1 to {MOST_PRECOMPUTED}")
    axes = set()
    while True:
        reader.comma()
        word = _axis(reader)
        if word is None:
            return {"precompute": (depth, "x" in axes, "y" in axes, "z" in axes)}
        axes.add(word)


def _axis(reader: ItemReader) -> str | None:
    """One of x, y, z: they come as the vectors that they are everywhere."""
    if reader.is_number():
        axis = reader.vector()
        return "xyz"[max(range(3), key=lambda i: axis[i])]
    return reader.word("x", "y", "z")


PARAMETRIC_FIELDS: Final[dict[str, Field]] = {
    "accuracy": number("accuracy"),
    "max_gradient": number("max_gradient"),
    "precompute": _precompute,
}


@shape(
    "parametric",
    signature="function {} function {} function {} <u,v>, <u,v> [contained_by {}] [max_gradient F] ...",
    doc="A surface given by three functions of u and v.",
    accepts=("function", "contained_by", *PARAMETRIC_FIELDS),
)
def parametric(reader: ItemReader, context: Context) -> Shape:
    functions = (read_function(reader), read_function(reader), read_function(reader))
    low, high = reader.vector2(), reader.vector2()
    return Parametric(functions, low, high, **_read_parameters(reader, PARAMETRIC_FIELDS))


JULIA_FUNCTIONS: Final = (
    *("sqr", "cube", "exp", "reciprocal", "sin", "asin", "sinh", "asinh", "cos", "acos", "cosh", "acosh"),
    *("tan", "atan", "tanh", "atanh", "ln", "log", "pwr"),
)


def _slice(reader: ItemReader) -> dict[str, Any]:
    normal = reader.vector4()
    if normal[3] == 0.0:
        reader.refuse("a slice vector whose fourth component is not 0")
    return {"slice_normal": normal, "slice_distance": reader.float()}


JULIA_FIELDS: Final[dict[str, Field]] = {
    "max_iteration": count("max_iteration", 10_000),
    "precision": number("precision"),
    "slice": _slice,
    "quaternion": lambda reader: {"algebra": "quaternion"},
    "hypercomplex": lambda reader: {"algebra": "hypercomplex"},
}


@shape(
    "julia_fractal",
    signature="<4 numbers> [quaternion|hypercomplex] [function] [max_iteration I] [precision F] [slice V4, F]",
    doc="A slice through a Julia set in four dimensions.",
    accepts=(*JULIA_FIELDS, *JULIA_FUNCTIONS),
)
def julia_fractal(reader: ItemReader, context: Context) -> Shape:
    place, parameter = reader.place, reader.vector4()
    said: dict[str, Any] = {}
    while True:
        fields = read_fields(reader, JULIA_FIELDS)
        if fields is not None:
            said.update(fields)
            continue
        word = reader.word_of(JULIA_FUNCTIONS)
        if word is None:
            break
        said["function"] = word
        if word == "pwr":
            exponent: Vec2 = (reader.float(), reader.float())
            said["exponent"] = exponent
    if said.get("function", "sqr") not in ("sqr", "cube") and said.get("algebra") != "hypercomplex":
        context.messages.warn("only sqr and cube are known to quaternions: sqr taken", place)
        said["function"] = "sqr"
    said["precision"] = max(said.get("precision", 20.0), 1.0)
    return JuliaFractal(parameter, **said)
