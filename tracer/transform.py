"""SDL: ``translate V``, ``scale V``, ``rotate V``, ``matrix <12 numbers>``, ``transform { ... }``.

Points are row vectors: ``q = p * M + row 4``. Rotation is left-handed, in degrees, about x, then y, then z.
"""

from __future__ import annotations

from math import cos, radians, sin
from typing import TypeAlias

from minipov.tracer.node import node
from minipov.tracer.values import Vec3

Matrix: TypeAlias = tuple[float, float, float, float, float, float, float, float, float, float, float, float]


@node
class Transform:
    """An affine map: the twelve numbers of SDL's ``matrix``, row by row."""

    matrix: Matrix = (1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0)

    @staticmethod
    def translate(v: Vec3) -> Transform:
        """A shift by ``v``."""
        return Transform((1, 0, 0, 0, 1, 0, 0, 0, 1, *v))

    @staticmethod
    def scale(v: Vec3) -> Transform:
        """A stretch along the axes; no component may be zero."""
        return Transform((v[0], 0, 0, 0, v[1], 0, 0, 0, v[2], 0, 0, 0))

    @staticmethod
    def rotate(degrees: Vec3) -> Transform:
        """Turns about x, then y, then z, in degrees, left-handed."""
        total = IDENTITY
        for axis, angle in enumerate(degrees):
            if angle:
                c, s = cos(radians(angle)), sin(radians(angle))
                about_x = (1, 0, 0, 0, c, s, 0, -s, c, 0, 0, 0)
                about_y = (c, 0, -s, 0, 1, 0, s, 0, c, 0, 0, 0)
                about_z = (c, s, 0, -s, c, 0, 0, 0, 1, 0, 0, 0)
                total = total.then(Transform((about_x, about_y, about_z)[axis]))
        return total

    def then(self, after: Transform) -> Transform:
        """First this map, then ``after``."""
        if self is IDENTITY:
            return after
        if after is IDENTITY:
            return self
        a, b, c, d, e, f, g, h, i, x, y, z = self.matrix
        p, q, r, s, t, u, v, w, o, *shift = after.matrix
        return Transform(
            (
                *(a * p + b * s + c * v, a * q + b * t + c * w, a * r + b * u + c * o),
                *(d * p + e * s + f * v, d * q + e * t + f * w, d * r + e * u + f * o),
                *(g * p + h * s + i * v, g * q + h * t + i * w, g * r + h * u + i * o),
                x * p + y * s + z * v + shift[0],
                x * q + y * t + z * w + shift[1],
                x * r + y * u + z * o + shift[2],
            )
        )

    def inverse(self) -> Transform:
        """The map that undoes this one.

        Raises:
            ZeroDivisionError: the map flattens space, so nothing undoes it.
        """
        a, b, c, d, e, f, g, h, i, *shift = self.matrix
        minors = [e * i - f * h, c * h - b * i, b * f - c * e, f * g - d * i, a * i - c * g, c * d - a * f]
        minors += [d * h - e * g, b * g - a * h, a * e - b * d]
        det = a * minors[0] + b * minors[3] + c * minors[6]
        linear = Transform((*(m / det for m in minors), 0, 0, 0))  # type: ignore[arg-type]
        x, y, z = linear.direction((shift[0], shift[1], shift[2]))
        return Transform((*linear.matrix[:9], -x, -y, -z))

    def direction(self, v: Vec3) -> Vec3:
        """Image of a direction."""
        m = self.matrix
        return (
            v[0] * m[0] + v[1] * m[3] + v[2] * m[6],
            v[0] * m[1] + v[1] * m[4] + v[2] * m[7],
            v[0] * m[2] + v[1] * m[5] + v[2] * m[8],
        )

    def point(self, p: Vec3) -> Vec3:
        """Image of a point."""
        x, y, z = self.direction(p)
        return (x + self.matrix[9], y + self.matrix[10], z + self.matrix[11])


IDENTITY = Transform()
