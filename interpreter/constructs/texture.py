"""SDL: ``texture { pigment {...} normal {...} finish {...} }``, layers, ``texture_map``, ``tiles``."""

from __future__ import annotations

from typing import Final

from minipov.interpreter.constructs.common import unexpected
from minipov.interpreter.constructs.finish import read_finish
from minipov.interpreter.constructs.layering import laid_over, layers
from minipov.interpreter.constructs.maps import read_entries
from minipov.interpreter.constructs.normal import SMOOTH, read_normal
from minipov.interpreter.constructs.pattern_modifiers import (
    PARAMETERS,
    PATTERN_MODIFIERS,
    read_pattern_modifier,
    read_pattern_parameter,
)
from minipov.interpreter.constructs.patterns import (
    PATTERN_WORDS,
    block_count,
    block_items,
    object_pattern,
    read_pattern,
)
from minipov.interpreter.constructs.pigment import read_pigment
from minipov.interpreter.constructs.transforms import TRANSFORM_WORDS, read_transform
from minipov.interpreter.context import Context
from minipov.interpreter.items import Sink, Unread
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.finish import Finish
from minipov.tracer.node import replace
from minipov.tracer.normal import Normal
from minipov.tracer.pattern import PLAIN, Pattern, SimplePattern
from minipov.tracer.pigment import Pigment
from minipov.tracer.texture import (
    LayeredTexture,
    MaterialMap,
    PatternTexture,
    PlainTexture,
    Texture,
    TextureList,
    TextureMap,
)

TEXTURE_TYPES: Final[tuple[type[Texture], ...]] = (PlainTexture, LayeredTexture, PatternTexture, MaterialMap)
_PARTS: Final = frozenset({"pigment", "normal", "finish"})
PLAIN_ACCEPTS: Final = ("pigment", "normal", "finish", *TRANSFORM_WORDS, "no_bump_scale", "uv_mapping")
PATTERN_ACCEPTS: Final = (*PATTERN_MODIFIERS, *PARAMETERS, "texture_map", "texture", "no_bump_scale")
ACCEPTS: Final = (*PLAIN_ACCEPTS, *PATTERN_WORDS, *PATTERN_ACCEPTS, "tiles", "material_map")


def layered(below: Texture | None, above: Texture, reader: ItemReader) -> Texture:
    """``above`` laid over ``below``. ``reader`` says where, should it be impossible."""
    if below is None:
        return above
    if not isinstance(below, PlainTexture | LayeredTexture):
        reader.refuse("no layer over a patterned texture", "only plain textures can be layers")
    if not isinstance(above, PlainTexture | LayeredTexture):
        reader.refuse("no patterned texture as a layer over another", "only plain textures can be layers")
    return laid_over(below, above)


def default_texture(context: Context) -> PlainTexture:
    """The default texture of the moment."""
    default = context.default_texture
    return default if isinstance(default, PlainTexture) else PlainTexture()


def modified_texture(reader: ItemReader, context: Context, texture: Texture | None) -> Texture | None:
    """``texture`` (or the default) changed by a ``pigment``, ``normal`` or ``finish`` block, or None if there is none.

    Of a layered texture the top layer changes.
    """
    item = reader.peek()
    if item.__class__ is not Unread or item.name not in _PARTS:
        return None
    base = texture or default_texture(context)
    if not isinstance(base, PlainTexture | LayeredTexture):
        reader.refuse("no pigment, normal or finish on a patterned texture", "only plain textures can be layers")
    reader.take()
    *lower, top = layers(base)
    pigment, normal, finish = top.pigment, top.normal, top.finish
    match item.name:
        case "pigment":
            pigment = read_pigment(item.reader.again(), context, pigment)
        case "normal":
            normal = read_normal(item.reader.again(), context, normal or SMOOTH)
        case "finish":
            finish = read_finish(item.reader.again(), context, finish)
    top = PlainTexture(pigment, normal, finish)
    return LayeredTexture((*lower, top)) if lower else top


def read_texture(reader: ItemReader, context: Context) -> Texture:
    """A texture block."""
    texture = read_texture_body(reader, context)
    if not reader.at_end:
        unexpected(reader, PATTERN_ACCEPTS if isinstance(texture, PatternTexture) else ACCEPTS)
    return texture


def read_texture_body(reader: ItemReader, context: Context) -> Texture:
    """As `read_texture`, up to the first item that belongs to no texture."""
    uv_mapping = reader.word("uv_mapping") is not None
    named = reader.node(TEXTURE_TYPES)
    texture: Texture
    if named is not None:
        texture = named
    else:
        by_object = object_pattern(reader, context)
        pattern = by_object[0] if by_object else read_pattern(reader, context)
        if pattern is not None:
            return _pattern_texture(reader, by_object[1] if by_object else reader, context, pattern, uv_mapping)
        texture = default_texture(context)
    no_bump_scale = False
    while not reader.at_end:
        if reader.word("no_bump_scale"):
            no_bump_scale = reader.boolean()
        elif reader.word("uv_mapping"):
            uv_mapping = True
        else:
            changed = _modified(reader, context, texture)
            if changed is None:
                break
            texture = changed
    if uv_mapping or no_bump_scale:
        texture = _flagged(texture, uv_mapping, no_bump_scale)
    return texture


def _modified(reader: ItemReader, context: Context, texture: Texture) -> Texture | None:
    transform = read_transform(reader, context)
    if transform is not None:
        return texture.transformed(transform)
    changed = modified_texture(reader, context, texture)
    if changed is not None:
        return changed
    if not isinstance(texture, PlainTexture | LayeredTexture):
        return None
    *lower, top = layers(texture)
    if (pigment := reader.node(Pigment)) is not None:
        top = replace(top, pigment=pigment)
    elif (normal := reader.node(Normal)) is not None:
        top = replace(top, normal=normal)
    elif (finish := reader.node(Finish)) is not None:
        top = replace(top, finish=finish)
    else:
        return None
    return LayeredTexture((*lower, top)) if lower else top


def _flagged(texture: Texture, uv_mapping: bool, no_bump_scale: bool) -> Texture:
    """``uv_mapping`` and ``no_bump_scale`` of a texture hold for what is in it."""
    if isinstance(texture, LayeredTexture):
        return LayeredTexture(tuple(_flagged_plain(layer, uv_mapping, no_bump_scale) for layer in texture.layers))
    if isinstance(texture, PlainTexture):
        return _flagged_plain(texture, uv_mapping, no_bump_scale)
    return replace(texture, modifiers=replace(texture.modifiers, uv_mapping=uv_mapping))


def _flagged_plain(texture: PlainTexture, uv_mapping: bool, no_bump_scale: bool) -> PlainTexture:
    pigment, normal = texture.pigment, texture.normal
    if uv_mapping:
        pigment = replace(pigment, modifiers=replace(pigment.modifiers, uv_mapping=True))
        normal = normal and replace(normal, modifiers=replace(normal.modifiers, uv_mapping=True))
    if no_bump_scale:
        normal = normal and replace(normal, no_bump_scale=True)
    return PlainTexture(pigment, normal, texture.finish)


def _pattern_texture(
    reader: ItemReader, items: ItemReader, context: Context, pattern: Pattern, uv_mapping: bool
) -> PatternTexture:
    """A pattern of whole textures; ``items`` reads the list of a block pattern."""
    count = block_count(pattern)
    given: list[Texture] = block_items(items, count, lambda: items.node(TEXTURE_TYPES))
    blend: TextureMap | TextureList | None = None
    if given:
        blend = TextureList((*given, *[default_texture(context)] * (count - len(given))))
    modifiers = replace(PLAIN, uv_mapping=uv_mapping)
    while not reader.at_end:
        changed = read_pattern_modifier(reader, context, modifiers)
        if changed is not None:
            modifiers = changed
            continue
        texture_map = reader.node(TextureMap)
        if texture_map is not None:
            blend = texture_map
            continue
        if reader.word("no_bump_scale"):
            reader.boolean()
            continue
        parameter = read_pattern_parameter(reader, pattern)
        if parameter is None:
            break
        pattern = parameter
    if blend is None:
        reader.fail("a texture_map or a list of textures for the pattern")
    return PatternTexture(pattern, blend, modifiers)


@construct(
    "texture",
    signature="[identifier] pigment, normal, finish, transformations | pattern texture_map",
    doc="The looks of a surface: pigment, normal and finish; several in a row are layers, the first lowest.",
    accepts=ACCEPTS,
)
def texture(reader: ItemReader, context: Context, sink: Sink) -> Texture:
    return read_texture(reader, context)


@construct(
    "texture_map",
    signature="[F texture items] [F texture items] ...",
    doc="Whole textures for the values 0 to 1 of a pattern; weights under `average`.",
    accepts=ACCEPTS,
)
def texture_map(reader: ItemReader, context: Context, sink: Sink) -> TextureMap:
    named = reader.node(TextureMap)
    if named is not None:
        return named
    return TextureMap(read_entries(reader, lambda inner: _entry_texture(inner, context)))


def _entry_texture(reader: ItemReader, context: Context) -> Texture:
    """An entry's texture: items without ``texture {}``, or whole texture blocks (several are layers)."""
    result = read_texture_body(reader, context)
    while (layer := reader.node(TEXTURE_TYPES)) is not None:
        result = layered(result, layer, reader)
    return result


@construct(
    "tiles",
    within=("texture",),
    signature="texture {} tile2 texture {}",
    doc="An old checker of two textures.",
    accepts=("texture", "tile2"),
)
def tiles(reader: ItemReader, context: Context, sink: Sink) -> PatternTexture:
    halves: list[Texture | None] = [None, None]
    at = 0
    while not reader.at_end:
        layer = reader.node(TEXTURE_TYPES)
        if layer is not None:
            halves[at] = layered(halves[at], layer, reader)
        elif at == 0 and reader.word("tile2"):
            at = 1
        else:
            unexpected(reader, ("texture", "tile2"))
    first, second = (half or default_texture(context) for half in halves)
    return PatternTexture(SimplePattern("checker"), TextureList((second, first)))
