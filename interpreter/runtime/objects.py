"""SDL: what a scene asks of things while it is read: ``trace``, ``inside``, ``min_extent``, ``dimensions`` ..."""

from __future__ import annotations

from typing import Any

from minipov.interpreter.arrays import Array
from minipov.interpreter.constructs.csg import has_inside
from minipov.interpreter.errors import SdlError
from minipov.interpreter.runtime.signature import builtin
from minipov.interpreter.values import Vector, kind_of, vector3
from minipov.tracer.objects import Object
from minipov.tracer.pattern import ImageMap
from minipov.tracer.pigment import Pigment

_asked: dict[int, tuple[Object, Any]] = {}
_MOST_KEPT = 16


def _question(value: Any) -> Any:
    """An object made ready for questions; the last few are kept, since scenes ask one object many times."""
    known = _asked.get(id(value))
    if known is not None and known[0] is value:
        return known[1]
    if not isinstance(value, Object):
        raise SdlError(f"expected an object, found {kind_of(value)}")
    from minipov.tracer import _core

    try:
        question = _core.Question(value)
    except RecursionError as error:
        raise SdlError(str(error)) from None
    while len(_asked) >= _MOST_KEPT:
        del _asked[next(iter(_asked))]
    _asked[id(value)] = (value, question)
    return question


@builtin("dimensions", 1)
def dimensions(array: Any) -> float:
    """How many dimensions an array has."""
    return float(len(_array(array).sizes))


@builtin("dimension_size", 2)
def dimension_size(array: Any, number: float) -> float:
    """The size of dimension ``number``, counted from 1; 0 where there is no such dimension."""
    sizes = _array(array).sizes
    return float(sizes[int(number) - 1]) if 1 <= int(number) <= len(sizes) else 0.0


def _array(value: Any) -> Array:
    if isinstance(value, Array):
        return value
    raise SdlError(f"expected an array, found {kind_of(value)}")


@builtin("inside", 2)
def inside(thing: Any, point: Any) -> float:
    """Whether a point is inside an object."""
    if isinstance(thing, Object) and not has_inside(thing):
        raise SdlError("patch objects have no inside", hint="meshes have one with an inside_vector")
    return float(_question(thing).inside(tuple(vector3(point))))


@builtin("trace", 3, 4)
def trace(thing: Any, start: Any, direction: Any, normal: Any = None) -> Vector:
    """The first point of an object that a ray meets, zero if none; the normal there goes into the fourth argument."""
    hit = _question(thing).trace(tuple(vector3(start)), tuple(vector3(direction)))
    point, at = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0)) if hit is None else hit
    if normal is not None:
        normal.v = Vector(at)
    return Vector(point)


def _extent(thing: Any, corner: int) -> Vector:
    if isinstance(thing, Pigment) and isinstance(thing.pattern, ImageMap):
        height, width = thing.pattern.mapping.image.color.shape[:2]
        return Vector((float(width), float(height), 0.0)) if corner else Vector((0.0, 0.0, 0.0))
    return Vector(_question(thing).extents()[corner])


@builtin("min_extent", 1)
def min_extent(thing: Any) -> Vector:
    """The lower corner of an object's bounding box."""
    return _extent(thing, 0)


@builtin("max_extent", 1)
def max_extent(thing: Any) -> Vector:
    """The upper corner of an object's bounding box; the size in pixels of an image pigment."""
    return _extent(thing, 1)
