"""SDL: the simple solids: ``sphere { <0,0,0>, 1 }  box { -1, 1 }  cylinder { 0, y, 0.5 open }  plane { y, 0 }`` ..."""

from __future__ import annotations

from math import dist
from typing import Final, Literal

from minipov.interpreter.constructs.common import number, read_fields
from minipov.interpreter.constructs.shape import shape
from minipov.interpreter.context import Context
from minipov.interpreter.errors import SdlError
from minipov.interpreter.reader import ItemReader
from minipov.tracer.objects import Shape
from minipov.tracer.shapes import (
    Box,
    Cone,
    Cylinder,
    Disc,
    Lemon,
    Ovus,
    Plane,
    Sphere,
    Superellipsoid,
    Torus,
)

SHORTEST_AXIS: Final = 1e-10


@shape("sphere", signature="center, radius", doc="A ball.")
def sphere(reader: ItemReader, context: Context) -> Shape:
    return Sphere(reader.vector(), reader.float())


@shape("box", signature="corner, corner", doc="A box along the axes, between two opposite corners in any order.")
def box(reader: ItemReader, context: Context) -> Shape:
    return Box(reader.vector(), reader.vector())


@shape("cylinder", signature="base, cap, radius [open]", doc="A round rod between two points.", accepts=("open",))
def cylinder(reader: ItemReader, context: Context) -> Shape:
    place = reader.place
    base, cap, radius = reader.vector(), reader.vector(), reader.float()
    if dist(base, cap) < SHORTEST_AXIS:
        raise SdlError("degenerate cylinder: its ends are the same point", place)
    return Cylinder(base, cap, radius)


@shape(
    "cone",
    signature="base, base radius, cap, cap radius [open]",
    doc="A cone or frustum between two points with a radius each.",
    accepts=("open",),
)
def cone(reader: ItemReader, context: Context) -> Shape:
    place = reader.place
    base, base_radius, cap, cap_radius = reader.vector(), reader.float(), reader.vector(), reader.float()
    if dist(base, cap) < SHORTEST_AXIS:
        raise SdlError("degenerate cone: its ends are the same point", place)
    if abs(base_radius - cap_radius) < 1e-10:
        return Cylinder(base, cap, base_radius)
    return Cone(base, base_radius, cap, cap_radius)


@shape(
    "plane", signature="normal, distance", doc="All space on one side of a plane; the inside lies against the normal."
)
def plane(reader: ItemReader, context: Context) -> Shape:
    place = reader.place
    normal, distance = reader.vector(), reader.float()
    if normal == (0.0, 0.0, 0.0):
        raise SdlError("degenerate plane: its normal has no length", place)
    return Plane(normal, distance)


@shape("disc", signature="center, normal, radius [, hole radius]", doc="A flat round plate, with a hole if you like.")
def disc(reader: ItemReader, context: Context) -> Shape:
    center, normal, radius = reader.vector(), reader.vector(), reader.float()
    return Disc(center, normal, radius, reader.float() if reader.is_number() else 0.0)


SPINDLES: tuple[Literal["difference", "intersection", "merge", "union"], ...] = (
    "difference",
    "intersection",
    "merge",
    "union",
)


@shape(
    "torus",
    signature="major radius, minor radius [sturm]",
    doc="A ring about the y axis.",
    accepts=("sturm", *SPINDLES),
)
def torus(reader: ItemReader, context: Context) -> Shape:
    major, minor = reader.float(), reader.float()
    word = reader.word_of(SPINDLES)
    return Torus(major, minor, next((mode for mode in SPINDLES if mode == word), None))


@shape(
    "superellipsoid",
    signature="<e, n>",
    doc="A shape between ball, box and octahedron: small exponents give sharp corners.",
)
def superellipsoid(reader: ItemReader, context: Context) -> Shape:
    return Superellipsoid(*reader.vector2())


@shape(
    "ovus",
    signature="bottom radius, top radius",
    doc="An egg: two balls, joined smoothly.",
    accepts=("radius", "distance", "precision"),
)
def ovus(reader: ItemReader, context: Context) -> Shape:
    bottom, top = reader.float(), reader.float()
    table = {word: number(word) for word in ("radius", "distance", "precision")}
    said: dict[str, float] = {}
    while (fields := read_fields(reader, table)) is not None:
        said.update(fields)
    return Ovus(bottom, top, **said)


@shape(
    "lemon",
    signature="base, base radius, cap, cap radius, inner radius [open]",
    doc="A spindle between two points (3.8).",
    accepts=("open",),
)
def lemon(reader: ItemReader, context: Context) -> Shape:
    base, base_radius = reader.vector(), reader.float()
    cap, cap_radius = reader.vector(), reader.float()
    return Lemon(base, base_radius, cap, cap_radius, reader.float())
