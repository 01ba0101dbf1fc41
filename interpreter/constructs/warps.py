"""SDL: ``warp { repeat x*2 flip y }  warp { turbulence 0.5 octaves 3 }  warp { black_hole <0,0,0>, 1 }`` ..."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

from minipov.interpreter.constructs.common import (
    Field,
    number,
    read_all_fields,
    switch,
    unexpected,
    vector,
)
from minipov.interpreter.context import Context
from minipov.interpreter.items import Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.transform import Transform
from minipov.tracer.warp import (
    BlackHoleWarp,
    CubicWarp,
    CylindricalWarp,
    PlanarWarp,
    RepeatWarp,
    SphericalWarp,
    ToroidalWarp,
    Turbulence,
    Warp,
)

WARP_TYPES: Final[tuple[type[Warp], ...]] = (
    Turbulence,
    RepeatWarp,
    BlackHoleWarp,
    CylindricalWarp,
    SphericalWarp,
    ToroidalWarp,
    PlanarWarp,
    CubicWarp,
)

TURBULENCE_FIELDS: Final[dict[str, Field]] = {
    "turbulence": vector("amount"),
    "octaves": lambda reader: {"octaves": min(max(reader.integer(), 1), 10)},
    "omega": number("omega"),
    "lambda": number("lambda_"),
}
MAPPING_FIELDS: Final[dict[str, Field]] = {"orientation": vector("orientation"), "dist_exp": number("dist_exp")}
BLACK_HOLE_FIELDS: Final[dict[str, Field]] = {
    "strength": number("strength"),
    "falloff": number("falloff"),
    "inverse": switch("inverse"),
    "type": lambda reader: {"type": reader.integer()},
    "repeat": vector("repeat"),
    "turbulence": vector("turbulence"),
}


def _repeat(reader: ItemReader) -> RepeatWarp:
    amount = reader.vector()
    axes = [axis for axis in range(3) if amount[axis] != 0.0]
    if len(axes) != 1:
        reader.refuse("a repeat vector along one axis", "write for example: repeat 2*x")
    said = read_all_fields(
        reader,
        {"offset": vector("offset"), "flip": lambda r: {"flip": tuple(value != 0.0 for value in r.vector())}},
    )
    return RepeatWarp(axes[0], amount[axes[0]], **said)


def _black_hole(reader: ItemReader) -> BlackHoleWarp:
    center, radius = reader.vector(), reader.float()
    said = read_all_fields(reader, BLACK_HOLE_FIELDS)
    said.pop("type", None)
    return BlackHoleWarp(center, radius, **said)


def _planar(reader: ItemReader) -> PlanarWarp:
    return PlanarWarp(reader.vector(), reader.float()) if reader.is_number() else PlanarWarp()


def _turbulence(reader: ItemReader) -> Turbulence:
    said: dict[str, Any] = {"amount": reader.vector()}
    return Turbulence(
        **said, **read_all_fields(reader, {k: v for k, v in TURBULENCE_FIELDS.items() if k != "turbulence"})
    )


WARPS: Final[dict[str, Callable[[ItemReader], Warp]]] = {
    "repeat": _repeat,
    "black_hole": _black_hole,
    "turbulence": _turbulence,
    "cylindrical": lambda reader: CylindricalWarp(**read_all_fields(reader, MAPPING_FIELDS)),
    "spherical": lambda reader: SphericalWarp(**read_all_fields(reader, MAPPING_FIELDS)),
    "toroidal": lambda reader: ToroidalWarp(
        **read_all_fields(reader, {**MAPPING_FIELDS, "major_radius": number("major_radius")})
    ),
    "planar": _planar,
    "cubic": lambda reader: CubicWarp(),
}


@construct(
    "warp",
    signature="repeat V ... | black_hole V, F ... | turbulence V ... | cylindrical ... | planar [V, F] | cubic",
    doc="Bends the space in which a pattern lives. Warps and transformations act in the order in which they stand.",
    accepts=(*WARPS, *MAPPING_FIELDS, *BLACK_HOLE_FIELDS, *TURBULENCE_FIELDS, "flip", "offset", "major_radius"),
)
def warp(reader: ItemReader, context: Context, sink: Sink) -> Warp:
    transform = reader.node(Transform)
    if transform is not None:
        return transform
    word = reader.word_of(WARPS)
    if word is None:
        unexpected(reader, WARPS)
    return WARPS[word](reader)
