"""SDL: what may follow the numbers of any object: ``texture {...} pigment {...} hollow no_shadow translate x``."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from typing import Any, Final, get_args

from minipov.interpreter.constructs.common import boolean, switch, unexpected
from minipov.interpreter.constructs.finish import with_old_interior
from minipov.interpreter.constructs.material import Material
from minipov.interpreter.constructs.texture import TEXTURE_TYPES, layered, modified_texture
from minipov.interpreter.constructs.transforms import TRANSFORM_WORDS, read_transform
from minipov.interpreter.context import Context
from minipov.interpreter.reader import ItemReader
from minipov.tracer.interior import Interior
from minipov.tracer.node import replace
from minipov.tracer.objects import Modifiers, Object, PhotonBehaviour, Shape
from minipov.tracer.shapes import HeightField, Mesh

FLAGS: Final = {
    "hollow": boolean("hollow"),
    "no_shadow": switch("no_shadow"),
    "no_image": boolean("no_image"),
    "no_reflection": boolean("no_reflection"),
    "no_radiosity": boolean("no_radiosity"),
    "double_illuminate": boolean("double_illuminate"),
}
_FLAG_WORDS: Final = frozenset({*FLAGS, "inverse", "uv_mapping"})
BLOCKS: Final = (
    "texture",
    "interior_texture",
    "pigment",
    "normal",
    "finish",
    "interior",
    "material",
    "photons",
    "radiosity",
    "clipped_by",
    "bounded_by",
)
MODIFIERS: Final = (*FLAGS, *BLOCKS, *TRANSFORM_WORDS, "inverse", "uv_mapping")

SHAPE_SWITCHES: Final[dict[str, Callable[[ItemReader], Any]]] = {
    "sturm": lambda reader: reader.boolean(),
    "hierarchy": lambda reader: reader.boolean(),
    "open": lambda reader: True,
    "cutaway_textures": lambda reader: True,
    "split_union": lambda reader: reader.float() != 0.0,
}


def _switches_of(shape: type[Any]) -> tuple[str, ...]:
    own = {field.name for field in fields(shape)}
    always_on = {"hierarchy"} if shape in (HeightField, Mesh) else set()
    return tuple(word for word in SHAPE_SWITCHES if word in own | always_on)


_SWITCHES: Final[dict[type[Any], tuple[str, ...]]] = {shape: _switches_of(shape) for shape in get_args(Shape)}


def shape_switches(shape: Shape) -> tuple[str, ...]:
    """The modifiers that only some shapes accept: those that are fields of this one."""
    return _SWITCHES[type(shape)]


def read_modifiers(reader: ItemReader, context: Context, thing: Object) -> Object:
    """The object with all that stands in the rest of its block, in order: a transform moves what came before it."""
    while not reader.at_end:
        changed = _modified(reader, context, thing)
        if changed is None:
            unexpected(reader, (*MODIFIERS, *shape_switches(thing.shape)))
        thing = changed
    return with_old_interior(thing)


def _modified(reader: ItemReader, context: Context, thing: Object) -> Object | None:
    """The object after one modifier, or None where the next item is none."""
    transform = read_transform(reader, context)
    if transform is not None:
        return thing.transformed(transform)
    dressed = _dressed(reader, context, thing)
    if dressed is not None:
        return dressed
    modifiers = _flagged(reader, context, thing)
    if modifiers is not None:
        return replace(thing, modifiers=modifiers)
    own = shape_switches(thing.shape)
    word = reader.word_of(own) if own else None
    if word is not None:
        value = SHAPE_SWITCHES[word](reader)
        return replace(thing, shape=replace(thing.shape, **{word: value})) if hasattr(thing.shape, word) else thing
    if reader.is_color():
        context.messages.warn("a colour belongs in a pigment: ignored here", reader.place)
        reader.color()
        return thing
    return None


def _dressed(reader: ItemReader, context: Context, thing: Object) -> Object | None:
    """Texture, interior and material."""
    texture = reader.node(TEXTURE_TYPES)
    if texture is not None:
        return replace(thing, texture=layered(thing.texture, texture, reader))
    changed = modified_texture(reader, context, thing.texture)
    if changed is not None:
        return replace(thing, texture=changed)
    inner = reader.block("interior_texture")
    if inner is not None:
        if thing.texture is None:
            reader.refuse("a texture before the interior_texture", "give the object a texture {...} first")
        return replace(thing, interior_texture=layered(thing.interior_texture, inner, reader))
    interior = reader.node(Interior)
    if interior is not None:
        return replace(thing, interior=interior)
    material = reader.node(Material)
    if material is not None:
        return _with_material(thing, material, reader)
    return None


def _with_material(thing: Object, material: Material, reader: ItemReader) -> Object:
    texture, inner = thing.texture, thing.interior_texture
    if material.texture is not None:
        texture = layered(texture, material.texture, reader)
    if material.interior_texture is not None:
        inner = layered(inner, material.interior_texture, reader)
    return replace(thing, texture=texture, interior_texture=inner, interior=material.interior or thing.interior)


def _flagged(reader: ItemReader, context: Context, thing: Object) -> Modifiers | None:
    """Flags, photons, radiosity, clipping and bounding."""
    old = thing.modifiers
    word = reader.word_of(_FLAG_WORDS)
    if word == "inverse":
        return replace(old, inverse=not old.inverse)
    if word == "uv_mapping":
        if thing.texture is not None:
            reader.refuse("uv_mapping before the texture")
        return replace(old, uv_mapping=True)
    if word is not None:
        return replace(old, **FLAGS[word](reader))
    photons = reader.block("photons")
    if photons is not None:
        return replace(old, photons=replace(old.photons or PhotonBehaviour(), **photons))
    importance = reader.block("radiosity")
    if importance is not None:
        return replace(old, radiosity_importance=importance)
    clips = reader.block("clipped_by")
    if clips is not None:
        return replace(old, clipped_by=old.bounded_by if clips == "bounded_by" else (*old.clipped_by, *clips))
    bounds = reader.block("bounded_by")
    if bounds is not None:
        return replace(old, bounded_by=old.clipped_by if bounds == "clipped_by" else (*old.bounded_by, *bounds))
    return None
