"""SDL's operators where Python's own are not enough: division, tolerant relations, logic, ``? :``, truth."""

from __future__ import annotations

from math import inf
from typing import Any

from minipov.interpreter.context import current_context
from minipov.interpreter.errors import SdlError
from minipov.interpreter.runtime.places import current_place
from minipov.interpreter.values import EPSILON, Vector, compare, kind_of


def divide(a: Any, b: Any) -> Any:
    """``a / b``; division by zero warns and gives infinity."""
    try:
        return a / b
    except ZeroDivisionError:
        warn_of_zero()
        return inf
    finally:
        if b.__class__ is Vector and 0.0 in b:
            warn_of_zero()


def warn_of_zero() -> None:
    """Say that the scene divides by zero."""
    current_context().messages.warn("division by zero", current_place())


def negate(value: Any) -> Any:
    """``-a``."""
    return -value


def not_(value: Any) -> Any:
    """``!a``, term by term."""
    if value.__class__ is Vector:
        return Vector(float(abs(term) <= EPSILON) for term in value)
    if hasattr(value, "inverted"):
        return value.inverted()
    return float(abs(value) <= EPSILON)


def equal(a: Any, b: Any) -> Any:
    """``a = b``, within `EPSILON`."""
    if a.__class__ is Vector or b.__class__ is Vector:
        return compare(a, b, lambda p, q: abs(p - q) < EPSILON or p == q)
    if a.__class__ is str:
        return a == _string(b)
    return abs(a - b) < EPSILON or a == b


def unequal(a: Any, b: Any) -> Any:
    """``a != b``."""
    result = equal(a, b)
    return not_(result) if result.__class__ is Vector else not result


def less_equal(a: Any, b: Any) -> Any:
    """``a <= b``."""
    if a.__class__ is Vector or b.__class__ is Vector:
        return compare(a, b, lambda p, q: p - q < EPSILON or p == q)
    if a.__class__ is str:
        return a <= _string(b)
    return a - b < EPSILON or a == b


def greater_equal(a: Any, b: Any) -> Any:
    """``a >= b``."""
    return less_equal(b, a)


def _string(value: Any) -> str:
    if isinstance(value, str):
        return value
    raise SdlError(f"a string cannot be compared with {kind_of(value)}")


def both(a: Any, b: Any) -> Any:
    """``a & b``."""
    if a.__class__ is Vector or b.__class__ is Vector:
        return compare(a, b, lambda p, q: abs(p) > EPSILON and abs(q) > EPSILON)
    return float(abs(a) > EPSILON and abs(b) > EPSILON)


def either(a: Any, b: Any) -> Any:
    """``a | b``."""
    if a.__class__ is Vector or b.__class__ is Vector:
        return compare(a, b, lambda p, q: abs(p) > EPSILON or abs(q) > EPSILON)
    return float(abs(a) > EPSILON or abs(b) > EPSILON)


def choose(condition: Any, yes: Any, no: Any) -> Any:
    """``condition ? yes : no``; both were worked out."""
    return yes if truth(condition) else no


def truth(value: Any) -> bool:
    """Whether a number counts as true."""
    if value.__class__ is bool:
        return bool(value)
    if isinstance(value, float | int):
        return not -EPSILON <= value <= EPSILON
    raise SdlError(f"a condition is a number, not {kind_of(value)}")
