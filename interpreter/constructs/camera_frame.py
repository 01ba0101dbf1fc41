"""How ``look_at``, ``sky``, ``angle`` and the other vectors of a camera give its frame."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import radians, sqrt, tan
from typing import Any, Final

from minipov.tracer.camera import CameraKind
from minipov.tracer.transform import Transform
from minipov.tracer.values import Vec3

PARALLEL: Final = 1e-10
Z: Final = (0.0, 0.0, 1.0)


def cross(a: Vec3, b: Vec3) -> Vec3:
    """The vector at right angles to both (``x`` times ``y`` is ``z``)."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a: Vec3, b: Vec3) -> float:
    """The scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def length(v: Vec3) -> float:
    """The length."""
    return sqrt(dot(v, v))


def scaled(v: Vec3, factor: float) -> Vec3:
    """The vector times a number."""
    return (v[0] * factor, v[1] * factor, v[2] * factor)


def difference(a: Vec3, b: Vec3) -> Vec3:
    """``a - b``."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def unit(v: Vec3) -> Vec3:
    """The vector of length 1; zero stays zero."""
    size = length(v)
    return scaled(v, 1.0 / size) if size else v


@dataclass(slots=True)
class Frame:
    """A camera's vectors while they are being set, one after the other.

    The setters do what the keyword of their name does at that point: ``angle`` stretches the direction, ``look_at``
    turns all three vectors.
    """

    kind: CameraKind = "perspective"
    location: Vec3 = (0.0, 0.0, 0.0)
    direction: Vec3 = Z
    right: Vec3 = (1.33, 0.0, 0.0)
    up: Vec3 = (0.0, 1.0, 0.0)
    sky: Vec3 = (0.0, 1.0, 0.0)
    look_at: Vec3 = Z
    focal_point: Vec3 | None = None
    angle: float | None = None
    sized: bool = False
    warnings: list[str] = field(default_factory=list)

    def act(self, word: str, value: Any) -> None:
        """What the keyword ``word`` does to the frame.

        Raises:
            ValueError: ``look_at`` is where the camera is.
        """
        match word:
            case "angle":
                self.set_angle(value)
            case "look_at":
                self.set_look_at(value)
            case "transform":
                self.transform(value)
            case _:
                setattr(self, word, value)
                self.sized = self.sized or word in ("right", "up")

    def set_angle(self, degrees: float) -> None:
        """Perspective: the direction gets the length that shows ``degrees`` over the width."""
        self.angle = degrees
        if self.kind == "perspective":
            self.direction = scaled(unit(self.direction), length(self.right) / tan(radians(degrees) / 2.0) / 2.0)

    def set_look_at(self, target: Vec3) -> None:
        """Turn to ``target``, with ``sky`` upwards as far as can be; lengths and handedness stay.

        Raises:
            ValueError: the target is where the camera is.
        """
        self.look_at = target
        view = difference(target, self.location)
        if view == (0.0, 0.0, 0.0):
            raise ValueError("look_at is the camera's location")
        sizes = length(self.direction), length(self.right), length(self.up)
        left_handed = dot(cross(self.up, self.direction), self.right) > 0.0
        direction = unit(view)
        right = cross(unit(self.sky), direction)
        if length(right) < PARALLEL:
            self.warnings.append("the camera looks along its sky vector")
            right = self.right
        right = unit(right)
        up = cross(direction, right)
        self.direction = scaled(direction, sizes[0])
        self.right = scaled(right, sizes[1] if left_handed else -sizes[1])
        self.up = scaled(up, sizes[2])

    def transform(self, transform: Transform) -> None:
        """Carry the camera along."""
        self.location = transform.point(self.location)
        self.direction = transform.direction(self.direction)
        self.right = transform.direction(self.right)
        self.up = transform.direction(self.up)

    def size_orthographic(self, bare_angle: bool) -> None:
        """An orthographic camera shows what the perspective one would, at the distance of ``look_at``."""
        if self.kind != "orthographic":
            return
        distance = length(difference(self.look_at, self.location))
        if self.angle is not None:
            factor = 2.0 * distance * tan(radians(self.angle) / 2.0) / length(self.right)
        elif bare_angle or not self.sized:
            factor = distance / length(self.direction)
        else:
            return
        self.right, self.up = scaled(self.right, factor), scaled(self.up, factor)
