"""SDL: the patterns: ``bozo``, ``gradient x``, ``crackle form <1,0,0>``, ``function {...}``, ``object {...}``, ..."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final, Literal, TypeVar

import numpy as np
from minipov.interpreter.constructs.common import expect_end, unexpected, unread
from minipov.interpreter.constructs.files import find
from minipov.interpreter.constructs.pattern_modifiers import (
    PARAMETERS,
    PATTERN_MODIFIERS,
    read_pattern_modifier,
    read_pattern_parameter,
)
from minipov.interpreter.context import Context
from minipov.interpreter.errors import SdlError
from minipov.interpreter.items import Sink, Unread
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer import function as functions
from minipov.tracer.function import PatternFunction
from minipov.tracer.objects import Object
from minipov.tracer.pattern import (
    PLAIN,
    Agate,
    Brick,
    Crackle,
    DensityFile,
    Facets,
    Fractal,
    FunctionPattern,
    Gradient,
    ImageMap,
    ImagePattern,
    ObjectPattern,
    Pattern,
    Pavement,
    PigmentPattern,
    Potential,
    Quilted,
    SimplePattern,
    Slope,
    Spiral,
    Tiling,
)
from numpy.typing import NDArray

T = TypeVar("T")

SIMPLE_PATTERNS: Final = (
    *("aoi", "average", "boxed", "bozo", "bumps", "cells", "checker", "cubic", "cylindrical", "dents", "granite"),
    *("hexagon", "leopard", "marble", "onion", "planar", "radial", "ripples", "spherical", "spotted", "square"),
    *("triangular", "waves", "wood", "wrinkles"),
)
BLOCK_COUNTS: Final = {"checker": 2, "brick": 2, "hexagon": 3, "square": 4, "triangular": 6, "cubic": 6, "object": 2}
FUNCTION_TYPES: Final[tuple[type[functions.Function], ...]] = (
    functions.ExpressionFunction,
    functions.InternalFunction,
    functions.PatternFunction,
    functions.PigmentFunction,
    functions.SplineFunction,
)
PATTERN_BLOCKS: Final[tuple[type[Pattern], ...]] = (ImageMap, ImagePattern, PigmentPattern, Potential, Slope)

MOST_ITERATIONS: Final = 100_000


def _simple(name: str) -> Callable[[ItemReader, Context], Pattern]:
    pattern = SimplePattern(name)
    return lambda reader, context: pattern


def _julia(reader: ItemReader, context: Context) -> Pattern:
    coordinate = reader.vector2()
    return Fractal(reader.count(MOST_ITERATIONS), coordinate)


def _mandel(reader: ItemReader, context: Context) -> Pattern:
    return Fractal(reader.count(MOST_ITERATIONS))


def _magnet(reader: ItemReader, context: Context) -> Pattern:
    kind = reader.integer()
    if kind not in (1, 2):
        reader.refuse("magnet 1 or magnet 2")
    coordinate = None
    if reader.word("julia"):
        coordinate = reader.vector2()
    elif not reader.word("mandel"):
        reader.fail("'mandel' or 'julia' after magnet")
    return Fractal(reader.count(MOST_ITERATIONS), coordinate, kind)


def _facets(reader: ItemReader, context: Context) -> Pattern:
    return Facets()


def _spiral(kind: Literal[1, 2]) -> Callable[[ItemReader, Context], Pattern]:
    return lambda reader, context: Spiral(kind, reader.integer())


def _tiling(reader: ItemReader, context: Context) -> Pattern:
    number = reader.integer()
    if not 1 <= number <= 27:
        context.messages.warn("tiling: number must be 1 to 27, taken as 1", reader.place)
        number = 1
    return Tiling(number)


def _gradient(reader: ItemReader, context: Context) -> Pattern:
    return Gradient(reader.vector())


def _slope(reader: ItemReader, context: Context) -> Pattern:
    # Without braces it takes nothing but the direction: a number after that is the amount of bumps.
    return Slope(reader.vector())


def _density_file(reader: ItemReader, context: Context) -> Pattern:
    if not reader.word("df3"):
        reader.fail("the file type df3")
    place = reader.place
    path = find(reader, context, "df3")
    try:
        return DensityFile(read_df3(path.read_bytes()))
    except (OSError, ValueError) as error:
        raise SdlError(f"{path}: {error}", place) from error


def read_df3(data: bytes) -> NDArray[np.float32]:
    """The voxels (z, y, x) in 0..1 of a DF3 file: three 16-bit sizes, then big-endian numbers of 8, 16 or 32 bits.

    Raises:
        ValueError: the file's length fits none of these.
    """
    if len(data) < 6:
        raise ValueError("not a density file")
    nx, ny, nz = np.frombuffer(data, ">u2", 3).astype(int)
    count = int(nx * ny * nz)
    width = (len(data) - 6) // count if count else 0
    size = 4 if width >= 4 else 2 if width >= 2 else width
    if size == 0:
        raise ValueError("density file is too short")
    voxels = np.frombuffer(data, f">u{size}", count, 6) / float(2 ** (8 * size) - 1)
    return voxels.astype(np.float32).reshape(nz, ny, nx)


PATTERNS: Final[dict[str, Callable[[ItemReader, Context], Pattern]]] = {
    **{name: _simple(name) for name in SIMPLE_PATTERNS},
    "agate": lambda reader, context: Agate(),
    "brick": lambda reader, context: Brick(),
    "crackle": lambda reader, context: Crackle(),
    "quilted": lambda reader, context: Quilted(),
    "pavement": lambda reader, context: Pavement(),
    "facets": _facets,
    "gradient": _gradient,
    "julia": _julia,
    "mandel": _mandel,
    "magnet": _magnet,
    "slope": _slope,
    "spiral1": _spiral(1),
    "spiral2": _spiral(2),
    "tiling": _tiling,
    "density_file": _density_file,
}
PATTERN_WORDS: Final = (
    *PATTERNS,
    *("function", "image_map", "image_pattern", "pigment_pattern", "object", "potential"),
)


def read_pattern(reader: ItemReader, context: Context) -> Pattern | None:
    """The pattern that starts here, or None. An ``object`` pattern's two items are left to `object_pattern_items`."""
    word = reader.word_of(PATTERNS)
    if word is not None:
        return PATTERNS[word](reader, context)
    block = reader.node(PATTERN_BLOCKS)
    if block is not None:
        return block
    function = reader.node(FUNCTION_TYPES)
    if function is not None:
        return FunctionPattern(function)
    return None


def pattern_word(pattern: Pattern) -> str:
    """The keyword of a block pattern; "" for patterns with a class of their own."""
    if isinstance(pattern, SimplePattern):
        return pattern.name
    return {Brick: "brick", ObjectPattern: "object"}.get(type(pattern), "")


def block_count(pattern: Pattern) -> int:
    """How many kinds of block a block pattern has; 0 for all others."""
    return BLOCK_COUNTS.get(pattern_word(pattern), 0)


def block_items(reader: ItemReader, count: int, take: Callable[[], T | None]) -> list[T]:
    """Up to ``count`` items of a block pattern, with optional commas before them."""
    given: list[T] = []
    while len(given) < count:
        reader.comma()
        item = take()
        if item is None:
            break
        given.append(item)
    return given


def object_pattern(reader: ItemReader, context: Context) -> tuple[ObjectPattern, ItemReader] | None:
    """An ``object { OBJECT items }`` pattern and the reader of its items, or None."""
    inner = unread(reader, "object")
    if inner is None:
        return None
    thing = inner.node(Object)
    if thing is None:
        inner.fail("an object")
    return ObjectPattern(thing), inner


@construct(
    "object",
    within=("pigment", "normal", "density", "texture", "pattern", "["),
    signature="object items",
    doc="As a pattern: one item outside the object, another inside it.",
)
def object_as_pattern(reader: ItemReader, context: Context, sink: Sink) -> Unread:
    return Unread("object", reader, lambda items: items.node(Object))


def read_slope(reader: ItemReader) -> Slope:
    """``[point_at] V [, low, high] [altitude V [, low, high]]``."""
    point_at = reader.word("point_at") is not None
    said: dict[str, Any] = {"direction": reader.vector(), "point_at": point_at}
    if reader.is_number():
        said |= {"low": reader.float(), "high": reader.float()}
    if reader.word("altitude"):
        said["altitude"] = reader.vector()
        if reader.is_number():
            said |= {"altitude_low": reader.float(), "altitude_high": reader.float()}
    return Slope(**said)


@construct(
    "slope",
    signature="{ [point_at] V [, F, F] [altitude V [, F, F]] }",
    doc="A pattern of how much the surface faces a direction (or a point), with an optional share of altitude.",
    accepts=("point_at", "altitude"),
)
def slope(reader: ItemReader, context: Context, sink: Sink) -> Slope:
    pattern = read_slope(reader)
    expect_end(reader, ("point_at", "altitude"))
    return pattern


@construct(
    "potential",
    signature="object [threshold B]",
    doc="The field of a blob or isosurface as a pattern (3.8).",
    accepts=("threshold",),
)
def potential(reader: ItemReader, context: Context, sink: Sink) -> Potential:
    thing = reader.node(Object)
    if thing is None:
        reader.fail("a blob or an isosurface")
    threshold = reader.word("threshold") is not None and reader.boolean()
    expect_end(reader, ("threshold",))
    return Potential(thing, threshold)


@construct(
    "pattern",
    signature="pattern and its modifiers",
    doc="A pattern's value as a function of x, y, z.",
    accepts=(*PATTERN_WORDS, *PATTERN_MODIFIERS, *PARAMETERS),
)
def pattern(reader: ItemReader, context: Context, sink: Sink) -> PatternFunction:
    by_object = object_pattern(reader, context)
    kind = by_object[0] if by_object else read_pattern(reader, context)
    if kind is None:
        unexpected(reader, PATTERN_WORDS)
    modifiers = PLAIN
    while not reader.at_end:
        changed = read_pattern_modifier(reader, context, modifiers)
        if changed is not None:
            modifiers = changed
            continue
        parameter = read_pattern_parameter(reader, kind)
        if parameter is None:
            unexpected(reader, (*PATTERN_MODIFIERS, *PARAMETERS))
        kind = parameter
    return PatternFunction(kind, modifiers)
