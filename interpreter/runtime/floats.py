"""SDL: the functions that give a float: ``sin``, ``select``, ``bitwise_and``, ``rand``, ``vdot``, ``strlen`` ...

Where C's library gives infinity or "not a number", so do these; what POV-Ray refuses is an `SdlError`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import reduce
from typing import Any

from minipov.interpreter.errors import SdlError
from minipov.interpreter.runtime.signature import builtin
from minipov.interpreter.values import quotient, vector3

_INT_MIN, _INT_MAX = -(2**31), 2**31 - 1


def to_int(value: float) -> int:
    """A float as C's 32-bit int: cut towards zero; what does not fit becomes the smallest."""
    if _INT_MIN - 1 < value < _INT_MAX + 1:
        return int(value)
    return _INT_MIN


def _or_inf(function: Callable[..., float]) -> Callable[..., float]:
    """The function, with infinity for an overflow and "not a number" outside its domain."""

    def total(value: float) -> float:
        try:
            return function(value)
        except OverflowError:
            return math.inf
        except ValueError:
            return -math.nan

    return total


for _name in ("exp", "sinh", "cosh", "acosh", "atanh", "sin", "cos", "tan"):
    builtin(_name, 1)(_or_inf(getattr(math, _name)))
for _name in ("tanh", "asinh", "atan", "degrees", "radians"):
    builtin(_name, 1)(getattr(math, _name))


@builtin("mod", 2)
def mod(a: float, b: float) -> float:
    """The remainder, with the sign of ``a``."""
    try:
        return math.fmod(a, b)
    except ValueError:
        return -math.nan


builtin("abs", 1)(abs)


def _clamped(name: str, function: Callable[[float], float]) -> Callable[[Any, float], float]:
    def clamped(runtime: Any, value: float) -> float:
        if not -1.0 <= value <= 1.0:
            runtime.warn(f"{name} of {value:g}, which is not between -1 and 1")
            value = max(-1.0, min(1.0, value))
        return function(value)

    return clamped


builtin("asin", 1, runtime=True)(_clamped("asin", math.asin))
builtin("acos", 1, runtime=True)(_clamped("acos", math.acos))


@builtin("int", 1)
def cut(value: float) -> float:
    """Cut towards zero."""
    return float(to_int(value))


@builtin("floor", 1)
def floor(value: float) -> float:
    """The next whole number below."""
    return float(math.floor(value)) if math.isfinite(value) else value


@builtin("ceil", 1)
def ceil(value: float) -> float:
    """The next whole number above."""
    return float(math.ceil(value)) if math.isfinite(value) else value


@builtin("atan2", 2)
def atan2(y: float, x: float) -> float:
    """The angle of the point (x, y)."""
    if x == 0.0 and y == 0.0:
        raise SdlError("atan2(0, 0) has no value")
    return math.atan2(y, x)


@builtin("ln", 1)
def ln(value: float) -> float:
    """The natural logarithm."""
    if value <= 0.0:
        raise SdlError(f"ln of {value:g}: only numbers above zero have a logarithm")
    return math.log(value)


@builtin("log", 1)
def log(value: float) -> float:
    """The logarithm to base 10."""
    if value <= 0.0:
        raise SdlError(f"log of {value:g}: only numbers above zero have a logarithm")
    return math.log10(value)


@builtin("sqrt", 1)
def sqrt(value: float) -> float:
    """The square root."""
    if value < 0.0:
        raise SdlError(f"sqrt of {value:g}: negative numbers have no square root")
    return math.sqrt(value)


@builtin("sqr", 1)
def sqr(value: float) -> float:
    """The square (3.8)."""
    return float(value * value)


@builtin("pow", 2)
def power(base: float, exponent: float) -> float:
    """``base`` to the power of ``exponent``."""
    try:
        result = base**exponent
    except ZeroDivisionError:
        return math.inf
    except OverflowError:
        return math.inf
    if base == 0.0 and exponent == 0.0:
        raise SdlError("pow(0, 0) has no value")
    return result if result.__class__ is float else -math.nan


@builtin("div", 2)
def div(a: float, b: float) -> float:
    """The whole part of ``a / b``."""
    return float(to_int(quotient(a, b)))


builtin("max", 1, 10**6)(lambda *values: values[0] if len(values) == 1 else max(values))
builtin("min", 1, 10**6)(lambda *values: values[0] if len(values) == 1 else min(values))


@builtin("select", 3, 4)
def select(key: float, negative: Any, zero: Any, positive: Any = None) -> Any:
    """One of the values, by the sign of ``key``."""
    if key < 0.0:
        return negative
    return zero if positive is None or key == 0.0 else positive


def _bitwise(name: str, operation: Callable[[int, int], int]) -> None:
    builtin(name, 2, 10**6)(lambda *values: float(reduce(operation, map(to_int, values))))


_bitwise("bitwise_and", int.__and__)
_bitwise("bitwise_or", int.__or__)
_bitwise("bitwise_xor", int.__xor__)


@builtin("vdot", 2)
def vdot(a: Any, b: Any) -> float:
    """The scalar product."""
    (a1, a2, a3), (b1, b2, b3) = vector3(a), vector3(b)
    return a1 * b1 + a2 * b2 + a3 * b3


@builtin("vlength", 1)
def vlength(v: Any) -> float:
    """The length of a vector."""
    a, b, c = vector3(v)
    return math.sqrt(a * a + b * b + c * c)


@builtin("seed", 1, runtime=True)
def seed(runtime: Any, value: float) -> float:
    """Open a stream of random numbers; gives its number."""
    runtime.random.append(to_int(value) & 0xFFFFFFFF)
    return float(len(runtime.random) - 1)


@builtin("rand", 1, runtime=True)
def rand(runtime: Any, stream: float) -> float:
    """The next number, 0 to 1, of a stream: a linear congruence over 32 bits."""
    streams: list[int] = runtime.random
    at = int(stream)
    if not 0 <= at < len(streams):
        raise SdlError(f"there is no stream {at} of random numbers", hint="open one with seed()")
    streams[at] = state = (streams[at] * 1812433253 + 12345) & 0xFFFFFFFF
    return state / 0xFFFFFFFF
