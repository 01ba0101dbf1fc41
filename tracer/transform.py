"""SDL: ``translate V``, ``scale V``, ``rotate V``, ``matrix <12 numbers>``, ``transform { ... }``.

Points are row vectors: ``q = p * M + row 4``. Rotation is left-handed, in degrees, about x, then y, then z.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, radians, sin
from typing import TypeAlias

from minipov.tracer.values import Vec3

Matrix: TypeAlias = tuple[float, float, float, float, float, float, float, float, float, float, float, float]


@dataclass(frozen=True, slots=True)
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
        (cx, sx), (cy, sy), (cz, sz) = ((cos(radians(a)), sin(radians(a))) for a in degrees)
        about_x = Transform((1, 0, 0, 0, cx, sx, 0, -sx, cx, 0, 0, 0))
        about_y = Transform((cy, 0, -sy, 0, 1, 0, sy, 0, cy, 0, 0, 0))
        about_z = Transform((cz, sz, 0, -sz, cz, 0, 0, 0, 1, 0, 0, 0))
        return about_x.then(about_y).then(about_z)

    def then(self, after: Transform) -> Transform:
        """First this map, then ``after``."""
        if self is IDENTITY:
            return after
        if after is IDENTITY:
            return self
        m, n = self.matrix, after.matrix
        rows = [
            m[r] * n[c] + m[r + 1] * n[c + 3] + m[r + 2] * n[c + 6] + (n[c + 9] if r == 9 else 0.0)
            for r in (0, 3, 6, 9)
            for c in (0, 1, 2)
        ]
        return Transform(tuple(rows))  # type: ignore[arg-type]  # twelve by construction

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
