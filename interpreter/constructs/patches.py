"""SDL: flat and curved patches without inside: ``triangle``, ``smooth_triangle``, ``polygon``, ``bicubic_patch``."""

from __future__ import annotations

from math import sqrt
from typing import Any, Final

from minipov.interpreter.constructs.common import Field, bulk, integer, number, read_fields
from minipov.interpreter.constructs.rings import open_ring_start
from minipov.interpreter.constructs.shape import NOTHING, shape
from minipov.interpreter.context import Context
from minipov.interpreter.reader import ItemReader
from minipov.tracer.objects import Shape
from minipov.tracer.shapes import BicubicPatch, Polygon, SmoothTriangle, Triangle
from minipov.tracer.values import Vec3

SMALLEST_AREA: Final = 1e-10


def is_degenerate(a: Vec3, b: Vec3, c: Vec3) -> bool:
    """Whether three points lie on one line."""
    return sqrt(_dot(_face_normal(a, b, c), _face_normal(a, b, c))) < SMALLEST_AREA


def is_lopsided(corners: tuple[Vec3, Vec3, Vec3], normals: tuple[Vec3, Vec3, Vec3]) -> bool:
    """Whether the normals of a smooth triangle point to different sides of its plane; POV-Ray leaves such a one out."""
    face = _face_normal(*corners)
    sides = [_dot(face, normal) for normal in normals]
    return not (min(sides) > 0.0 or max(sides) < 0.0)


def _face_normal(a: Vec3, b: Vec3, c: Vec3) -> Vec3:
    u = (b[0] - a[0], b[1] - a[1], b[2] - a[2])
    v = (c[0] - a[0], c[1] - a[1], c[2] - a[2])
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def _dot(a: Vec3, b: Vec3) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@shape("triangle", signature="corner, corner, corner", doc="A flat triangle.")
def triangle(reader: ItemReader, context: Context) -> Shape:
    place = reader.place
    a, b, c = reader.vector(), reader.vector(), reader.vector()
    if is_degenerate(a, b, c):
        context.messages.warn("degenerate triangle: left out", place)
        return NOTHING
    return Triangle(a, b, c)


@shape(
    "smooth_triangle",
    signature="corner, normal, corner, normal, corner, normal",
    doc="A triangle shaded as if it were curved.",
)
def smooth_triangle(reader: ItemReader, context: Context) -> Shape:
    place = reader.place
    a, na, b, nb, c, nc = (reader.vector() for _ in range(6))
    if is_degenerate(a, b, c) or is_lopsided((a, b, c), (na, nb, nc)):
        context.messages.warn("degenerate triangle: left out", place)
        return NOTHING
    return SmoothTriangle(a, na, b, nb, c, nc)


@shape(
    "polygon",
    signature="count, point, point, ...",
    doc="A flat polygon; a repeated first point closes a ring, and overlapping rings are holes.",
)
def polygon(reader: ItemReader, context: Context) -> Shape:
    place = reader.place
    count = reader.integer()
    if count < 3:
        reader.refuse("at least 3 points")
    points: list[Vec3] = [(x, y, z) for x, y, z in bulk(reader, count, 3, "points").tolist()]
    start = open_ring_start(points)
    if start is not None:
        context.messages.warn("polygon is not closed: closed for you", place)
        points.append(start)
    return Polygon(tuple(points))


BICUBIC_FIELDS: Final[dict[str, Field]] = {
    "type": integer("type"),
    "flatness": number("flatness"),
    "u_steps": integer("u_steps"),
    "v_steps": integer("v_steps"),
    "accuracy": number("accuracy"),
}


@shape(
    "bicubic_patch",
    signature="type 0|1 [flatness F] [u_steps I] [v_steps I] [uv_vectors V2, V2, V2, V2], 16 points",
    doc="A Bézier patch over 4 times 4 control points.",
    accepts=(*BICUBIC_FIELDS, "uv_vectors"),
)
def bicubic_patch(reader: ItemReader, context: Context) -> Shape:
    said: dict[str, Any] = {}
    if reader.is_number():
        said = _old_style(reader)
    else:
        while (fields := read_fields(reader, BICUBIC_FIELDS)) is not None:
            said.update(fields)
            reader.comma()
    said.pop("accuracy", None)
    if said.get("type", 0) in (2, 3):
        context.messages.warn("bicubic_patch types 2 and 3 are obsolete: taken as 1", reader.place)
        said["type"] = 1
    if reader.word("uv_vectors"):
        said["uv_vectors"] = tuple((u, v) for u, v in bulk(reader, 4, 2, "uv vectors").tolist())
    points = bulk(reader, 16, 3, "control points").tolist()
    return BicubicPatch(tuple((x, y, z) for x, y, z in points), **said)


def _old_style(reader: ItemReader) -> dict[str, Any]:
    """``type, flatness, u_steps, v_steps`` (types 0 and 1) without keywords."""
    said: dict[str, Any] = {"type": reader.integer()}
    if said["type"] in (2, 3):
        reader.float()
    said["flatness"] = reader.float()
    said["u_steps"] = reader.integer()
    said["v_steps"] = reader.integer()
    return said
