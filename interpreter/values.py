"""The values of SDL: floats are Python floats, vectors and colours one immutable type.

A float beside a vector is copied to all terms; a shorter vector is padded with zeros; operators work term by term,
relations give 1 or 0 per term. ``V.x``, ``V.red``, ``V.gray`` are properties, so compiled code reads them as
attributes.
"""

from __future__ import annotations

from collections.abc import Callable
from math import inf, pi, tau
from operator import itemgetter
from struct import Struct
from typing import Any, Final, TypeAlias

EPSILON = 1e-10
"""Numbers closer than this are equal to SDL; anything further from zero is true."""

COMPONENTS = {
    "x": 0, "u": 0, "red": 0,
    "y": 1, "v": 1, "green": 1,
    "z": 2, "blue": 2,
    "t": 3, "filter": 3,
    "transmit": 4,
}  # fmt: skip
"""The names that may follow a period, and which term they pick; ``gray`` is computed."""

GRAY_WEIGHTS = (0.297, 0.589, 0.114)

_new = tuple.__new__


class Vector(tuple[float, ...]):
    """Two to five terms: a vector, or with five terms a colour (red, green, blue, filter, transmit).

    Literals with more terms (``matrix``, ``poly``) are vectors too, but nothing can be computed with them.
    """

    __slots__ = ()

    def padded(self, size: int) -> tuple[float, ...]:
        """The terms, with zeros up to ``size``."""
        return tuple(self) + (0.0,) * (size - len(self))

    def __add__(self, other: Any) -> Vector:
        if other.__class__ is Vector and len(self) == 3 == len(other):
            (a, b, c), (d, e, f) = self, other
            return _new(Vector, (a + d, b + e, c + f))
        return _termwise(self, other, float.__add__)

    def __radd__(self, other: Any) -> Vector:
        return _termwise(other, self, float.__add__)

    def __sub__(self, other: Any) -> Vector:
        if other.__class__ is Vector and len(self) == 3 == len(other):
            (a, b, c), (d, e, f) = self, other
            return _new(Vector, (a - d, b - e, c - f))
        return _termwise(self, other, float.__sub__)

    def __rsub__(self, other: Any) -> Vector:
        return _termwise(other, self, float.__sub__)

    def __mul__(self, other: Any) -> Vector:
        if other.__class__ is float:
            if len(self) == 3:
                a, b, c = self
                return _new(Vector, (a * other, b * other, c * other))
            return _new(Vector, [a * other for a in self])
        return _termwise(self, other, float.__mul__)

    def __rmul__(self, other: Any) -> Vector:
        if other.__class__ is float:
            if len(self) == 3:
                a, b, c = self
                return _new(Vector, (other * a, other * b, other * c))
            return _new(Vector, [other * a for a in self])
        return _termwise(other, self, float.__mul__)

    def __truediv__(self, other: Any) -> Vector:
        return _termwise(self, other, quotient)

    def __rtruediv__(self, other: Any) -> Vector:
        return _termwise(other, self, quotient)

    def __neg__(self) -> Vector:
        return _new(Vector, [-a for a in self])

    def __pos__(self) -> Vector:
        return self

    def __lt__(self, other: Any) -> Any:
        return compare(self, other, float.__lt__)

    def __gt__(self, other: Any) -> Any:
        return compare(self, other, float.__gt__)

    def __bool__(self) -> bool:
        raise TypeError("expected a number, found a vector")

    x = u = red = property(itemgetter(0))
    y = v = green = property(itemgetter(1))
    z = blue = property(itemgetter(2))
    t = filter = property(itemgetter(3))
    transmit = property(itemgetter(4))

    @property
    def gray(self) -> float:
        """The brightness of a colour."""
        return sum(weight * term for weight, term in zip(GRAY_WEIGHTS, self, strict=False))


Number: TypeAlias = float | Vector


def quotient(a: float, b: float) -> float:
    """``a / b``; dividing by zero gives infinity (the compiled program warns of it)."""
    return a / b if b else inf


def promoted(a: Any, b: Any) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Two operands as terms of one size.

    Raises:
        TypeError: one of them is not a number or vector.
    """
    a, b = terms(a), terms(b)
    if len(a) != len(b):
        size = max(len(a), len(b))
        if size > 5:
            raise TypeError("vectors of more than five terms cannot be computed with")
        a, b = widened(a, size), widened(b, size)
    return a, b


def terms(value: Any) -> tuple[float, ...]:
    """A number or vector as its terms."""
    if isinstance(value, Vector):
        return value
    if isinstance(value, float | int):
        return (float(value),)
    raise TypeError(f"expected a number or vector, found {kind_of(value)}")


def widened(value: tuple[float, ...], size: int) -> tuple[float, ...]:
    """One term copied to all places; several padded with zeros."""
    return value * size if len(value) == 1 else tuple(value) + (0.0,) * (size - len(value))


def _termwise(a: Any, b: Any, operation: Callable[[float, float], float]) -> Vector:
    if not isinstance(a, float | int | Vector) or not isinstance(b, float | int | Vector):
        return NotImplemented  # type: ignore[no-any-return]  # handed on by the operators
    return _new(Vector, map(operation, *promoted(a, b)))


def compare(a: Any, b: Any, operation: Callable[[float, float], bool]) -> Vector:
    """A relation of which at least one side is a vector, term by term."""
    return Vector(float(operation(p, q)) for p, q in zip(*promoted(a, b), strict=True))


_FIVE_SINGLES = Struct("5f")


def stored(value: Any) -> Any:
    """What a variable keeps of a value: colours are held in single precision."""
    if value.__class__ is not Vector or len(value) < 5:
        return value
    if len(value) > 5:
        raise TypeError(f"a vector has at most five terms, found {len(value)}")
    try:
        return _new(Vector, _FIVE_SINGLES.unpack(_FIVE_SINGLES.pack(*value)))
    except OverflowError:
        return value


def kind_of(value: Any) -> str:
    """What a value is, in the words of an error message, with its article."""
    if isinstance(value, float | int):
        return "a number"
    if isinstance(value, Vector):
        return "a vector" if len(value) < 5 else "a colour" if len(value) == 5 else f"{len(value)} numbers"
    if isinstance(value, str):
        return "a string"
    name = getattr(type(value), "sdl_kind", "") or _node_kind(type(value).__name__.lower())
    return f"an {name}" if name[0] in "aeiou" else f"a {name}"


def _node_kind(name: str) -> str:
    return next((kind for kind in ("texture", "function") if name.endswith(kind)), name)


def vector3(value: Any) -> tuple[float, float, float]:
    """Three terms, promoted.

    Raises:
        TypeError: not a vector, or one of more terms.
    """
    if value.__class__ is Vector and len(value) == 3:
        return value
    if isinstance(value, Vector) and len(value) > 3:
        raise TypeError(f"expected a vector of three terms, found one of {len(value)}")
    a, b, c = widened(terms(value), 3)
    return a, b, c


CONSTANT_WORDS: Final[dict[str, Any]] = {
    "x": Vector((1.0, 0.0, 0.0)), "y": Vector((0.0, 1.0, 0.0)), "z": Vector((0.0, 0.0, 1.0)),
    "u": Vector((1.0, 0.0)), "v": Vector((0.0, 1.0)), "t": Vector((0.0, 0.0, 0.0, 1.0)),
    "pi": pi, "tau": tau,
    "true": 1.0, "yes": 1.0, "on": 1.0, "false": 0.0, "no": 0.0, "off": 0.0,
}  # fmt: skip
"""Keywords that stand for a value, whatever the scene."""
