"""SDL: ``image_map { png "a.png" interpolate 2 once }``; ``bump_map``, ``image_pattern``, ``material_map``."""

from __future__ import annotations

from typing import Any, Final

from minipov.interpreter.constructs.common import Field, integer, number, read_fields, switch, unexpected
from minipov.interpreter.constructs.files import IMAGE_TYPES, find, image
from minipov.interpreter.constructs.function_images import sampled
from minipov.interpreter.constructs.texture import TEXTURE_TYPES
from minipov.interpreter.context import Context
from minipov.interpreter.items import Block, FunctionImage, Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.image import Image, ImageMapping, ImagePurpose
from minipov.tracer.node import replace
from minipov.tracer.pattern import BumpMap, ImageMap, ImagePattern
from minipov.tracer.settings import Gamma
from minipov.tracer.texture import MaterialMap, Texture

MAP_TYPES: Final = (0, 1, 2, 5, 7)


def _map_type(reader: ItemReader) -> dict[str, Any]:
    number = reader.integer()
    if number not in MAP_TYPES:
        reader.refuse("map_type 0, 1, 2, 5 or 7")
    return {"map_type": number}


MAPPING_FIELDS: Final[dict[str, Field]] = {
    "map_type": _map_type,
    "once": switch("once"),
    "interpolate": integer("interpolate"),
    "use_index": lambda reader: {"use": "index"},
    "use_color": lambda reader: {"use": "color"},
    "use_colour": lambda reader: {"use": "color"},
    "use_alpha": lambda reader: {"use": "alpha"},
    "repeat": lambda reader: {"repeat": reader.vector2()},
    "offset": lambda reader: {"offset": reader.vector2()},
}
ACCEPTS: Final = (*IMAGE_TYPES, "gamma", "premultiplied", *MAPPING_FIELDS)


def read_image(reader: ItemReader, context: Context, purpose: ImagePurpose) -> Image:
    """``[type] "file" [gamma G] [premultiplied B]``, or a function to be sampled."""
    source = reader.node(FunctionImage)
    if source is not None:
        return sampled(source)
    kind = reader.word_of(IMAGE_TYPES) or ""
    path = find(reader, context, kind)
    gamma: Gamma = None
    while True:
        if reader.word("gamma"):
            gamma = read_gamma(reader)
        elif reader.word("premultiplied"):
            reader.boolean()
        else:
            break
    return image(reader, context, path, kind, gamma=gamma, purpose=purpose)


def read_gamma(reader: ItemReader) -> Gamma:
    """``F`` or ``srgb``; the 3.8 curves bt709 and bt2020 count as srgb."""
    word = reader.word("srgb", "bt709", "bt2020")
    return reader.float() if word is None else "srgb"


def read_mapping(reader: ItemReader, context: Context, purpose: ImagePurpose) -> ImageMapping:
    """A picture and how it lies in space, up to the first other item."""
    picture = read_image(reader, context, purpose)
    said: dict[str, Any] = {}
    while (fields := read_fields(reader, MAPPING_FIELDS)) is not None:
        said.update(fields)
    return ImageMapping(picture, **said)


def _palette_item(reader: ItemReader) -> tuple[int | None, float]:
    """``all F`` or ``index, F``."""
    if reader.word("all"):
        return (None, reader.float())
    return (reader.integer(), reader.float())


@construct(
    "image_map",
    signature='[type] "file" [gamma G] [map_type I] [once] [interpolate I] [filter I, F] [transmit all F]',
    doc="A picture as pigment: the unit square of the xy-plane shows it, repeated for ever.",
    accepts=(*ACCEPTS, "filter", "transmit", "all"),
)
def image_map(reader: ItemReader, context: Context, sink: Sink) -> ImageMap:
    named = reader.node(ImageMap)
    if named is not None:
        return named
    mapping = read_mapping(reader, context, "color")
    filters: list[tuple[int | None, float]] = []
    transmits: list[tuple[int | None, float]] = []
    while not reader.at_end:
        if reader.word("filter"):
            filters.append(_palette_item(reader))
        elif reader.word("transmit"):
            transmits.append(_palette_item(reader))
        else:
            fields = read_fields(reader, MAPPING_FIELDS)
            if fields is None:
                unexpected(reader, (*ACCEPTS, "filter", "transmit"))
            mapping = replace(mapping, **fields)
    return ImageMap(mapping, tuple(filters), tuple(transmits))


@construct(
    "image_pattern",
    signature='[type] "file" [map_type I] [once] [interpolate I] [use_alpha]',
    doc="The grey value of a picture as a pattern.",
    accepts=ACCEPTS,
)
def image_pattern(reader: ItemReader, context: Context, sink: Sink) -> ImagePattern:
    mapping = read_mapping(reader, context, "pattern")
    if not reader.at_end:
        unexpected(reader, ACCEPTS)
    return ImagePattern(mapping)


@construct(
    "bump_map",
    signature='[type] "file" [map_type I] [once] [interpolate I] [bump_size F]',
    doc="A picture as bumps: light is high.",
    accepts=(*ACCEPTS, "bump_size"),
)
def bump_map(reader: ItemReader, context: Context, sink: Sink) -> Block:
    mapping = read_mapping(reader, context, "pattern")
    amount: float | None = None
    while not reader.at_end:
        fields = read_fields(reader, {**MAPPING_FIELDS, "bump_size": number("bump_size")})
        if fields is None:
            unexpected(reader, (*ACCEPTS, "bump_size"))
        amount = fields.pop("bump_size", amount)
        mapping = replace(mapping, **fields)
    return Block("bump_map", (BumpMap(mapping), amount))


@construct(
    "material_map",
    signature='[type] "file" [map_type I] [once] texture {} texture {} ...',
    doc="A picture whose palette index chooses the texture.",
    accepts=(*ACCEPTS, "texture"),
)
def material_map(reader: ItemReader, context: Context, sink: Sink) -> MaterialMap:
    mapping = read_mapping(reader, context, "pattern")
    textures: list[Texture] = []
    while not reader.at_end:
        texture = reader.node(TEXTURE_TYPES)
        if texture is None:
            unexpected(reader, (*ACCEPTS, "texture"))
        textures.append(texture)
    if not textures:
        reader.fail("at least one texture")
    return MaterialMap(mapping, tuple(textures))
