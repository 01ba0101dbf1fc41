"""SDL: the functions that give a vector: ``vcross``, ``vnormalize``, ``vrotate``, ``vaxis_rotate``, ``vturbulence``."""

from __future__ import annotations

from math import cos, radians, sin, sqrt
from typing import Any

from minipov.interpreter.runtime.signature import builtin
from minipov.interpreter.values import Vector, vector3


@builtin("vcross", 2)
def vcross(a: Any, b: Any) -> Vector:
    """The vector product."""
    (a1, a2, a3), (b1, b2, b3) = vector3(a), vector3(b)
    return Vector((a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1))


@builtin("vnormalize", 1, runtime=True)
def vnormalize(runtime: Any, v: Any) -> Vector:
    """The vector made one long; zero stays zero, with a warning."""
    a, b, c = vector3(v)
    length = sqrt(a * a + b * b + c * c)
    if length == 0.0:
        runtime.warn("vnormalize of a vector of length zero")
        return Vector((0.0, 0.0, 0.0))
    return Vector((a / length, b / length, c / length))


@builtin("vrotate", 2)
def vrotate(v: Any, angles: Any) -> Vector:
    """Turned about x, then y, then z, in degrees, left-handed."""
    a, b, c = vector3(v)
    about_x, about_y, about_z = vector3(angles)
    if about_x:
        angle = radians(about_x)
        co, si = cos(angle), sin(angle)
        b, c = b * co - c * si, b * si + c * co
    if about_y:
        angle = radians(about_y)
        co, si = cos(angle), sin(angle)
        a, c = a * co + c * si, c * co - a * si
    if about_z:
        angle = radians(about_z)
        co, si = cos(angle), sin(angle)
        a, b = a * co - b * si, a * si + b * co
    return Vector((a, b, c))


@builtin("vaxis_rotate", 3)
def vaxis_rotate(v: Any, axis: Any, angle: float) -> Vector:
    """Turned by ``angle`` degrees about any axis (Rodrigues' formula)."""
    a, b, c = vector3(v)
    k1, k2, k3 = vector3(axis)
    length = sqrt(k1 * k1 + k2 * k2 + k3 * k3)
    if length == 0.0:
        return Vector((a, b, c))
    k1, k2, k3 = k1 / length, k2 / length, k3 / length
    co, si = cos(radians(angle)), sin(radians(angle))
    along = (k1 * a + k2 * b + k3 * c) * (1.0 - co)
    return Vector(
        (
            a * co + (k2 * c - k3 * b) * si + k1 * along,
            b * co + (k3 * a - k1 * c) * si + k2 * along,
            c * co + (k1 * b - k2 * a) * si + k3 * along,
        )
    )


@builtin("vturbulence", 4)
def vturbulence(lambda_: float, omega: float, octaves: float, point: Any) -> Vector:
    """The displacement that ``turbulence`` gives a point."""
    from minipov.tracer import _core

    return Vector(_core.vturbulence(float(lambda_), float(omega), int(octaves), vector3(point)))
