"""SDL: what a scene asks of things while it is read: ``trace``, ``inside``, ``min_extent``, ``dimensions`` ..."""

from __future__ import annotations

from typing import Any

from minipov.interpreter.arrays import Array
from minipov.interpreter.constructs.csg import has_inside
from minipov.interpreter.errors import SdlError
from minipov.interpreter.runtime.signature import builtin
from minipov.interpreter.values import Vector, kind_of, vector3
from minipov.tracer.node import replace
from minipov.tracer.objects import Intersection, Merge, Object, Union
from minipov.tracer.pattern import ImageMap
from minipov.tracer.pigment import Pigment
from minipov.tracer.transform import IDENTITY
from minipov.tracer.values import Vec3

_asked: dict[int, tuple[Object, Any]] = {}
_at_rest: dict[int, tuple[Object, Object]] = {}
_MOST_KEPT = 16
_COMPOSITE = (Union, Merge, Intersection)
_INFINITE = 1e10
"""What the core gives as the size of what has no end."""


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
    return Vector(_box(thing)[corner])


def _box(thing: Any) -> tuple[Vec3, Vec3]:
    """The bounding box. That of a composite object is moved with it, as in POV-Ray, so it may grow by a rotation."""
    modifiers = thing.modifiers if isinstance(thing, Object) else None
    if modifiers is None or modifiers.clipped_by or modifiers.bounded_by or not isinstance(thing.shape, _COMPOSITE):
        box: tuple[Vec3, Vec3] = _question(thing).extents()
        return box
    at = thing.transform
    low, high = _question(thing if at is IDENTITY else _resting(thing)).extents()
    if at is IDENTITY or max(*map(abs, low), *map(abs, high)) >= _INFINITE:
        return low, high
    corners = [at.point((x, y, z)) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
    (a, b, c), (d, e, f) = (tuple(map(pick, zip(*corners, strict=True))) for pick in (min, max))
    return (a, b, c), (d, e, f)


def _resting(thing: Object) -> Object:
    """The object where its parts are, the same at each call."""
    known = _at_rest.get(id(thing))
    if known is None or known[0] is not thing:
        _at_rest.clear()
        known = _at_rest[id(thing)] = (thing, replace(thing, transform=IDENTITY))
    return known[1]


@builtin("min_extent", 1)
def min_extent(thing: Any) -> Vector:
    """The lower corner of an object's bounding box."""
    return _extent(thing, 0)


@builtin("max_extent", 1)
def max_extent(thing: Any) -> Vector:
    """The upper corner of an object's bounding box; the size in pixels of an image pigment."""
    return _extent(thing, 1)
