"""SDL: ``texture { pigment {...} normal {...} finish {...} }``, layers, ``texture_map``, ``material_map``."""

from __future__ import annotations

from typing import TypeAlias

from minipov.tracer.finish import Finish
from minipov.tracer.image import ImageMapping
from minipov.tracer.node import node, replace
from minipov.tracer.normal import Normal
from minipov.tracer.pattern import PLAIN, Pattern, PatternModifiers
from minipov.tracer.pigment import Pigment
from minipov.tracer.transform import Transform


@node
class PlainTexture:
    """One pigment, normal and finish."""

    pigment: Pigment = Pigment()
    normal: Normal | None = None
    finish: Finish = Finish()

    def transformed(self, transform: Transform) -> PlainTexture:
        """The same texture, moved; itself where there is nothing to move, so that shared textures stay shared."""
        pigment = self.pigment.transformed(transform)
        normal = self.normal and self.normal.transformed(transform)
        if pigment is self.pigment and normal is self.normal:
            return self
        return PlainTexture(pigment, normal, self.finish)


@node
class LayeredTexture:
    """Textures on top of each other, the lowest first."""

    layers: tuple[PlainTexture, ...]

    def transformed(self, transform: Transform) -> LayeredTexture:
        """The same texture, moved."""
        return LayeredTexture(tuple(layer.transformed(transform) for layer in self.layers))


@node
class TextureMap:
    """``texture_map { [F texture] ... }``; the numbers are weights under ``average``."""

    entries: tuple[tuple[float, Texture], ...]


@node
class TextureList:
    """The textures of a block pattern (and of ``tiles``), one per kind of block."""

    textures: tuple[Texture, ...]


@node
class PatternTexture:
    """A pattern chooses between or mixes whole textures."""

    pattern: Pattern
    blend: TextureMap | TextureList
    modifiers: PatternModifiers = PLAIN

    def transformed(self, transform: Transform) -> PatternTexture:
        """The same texture, moved; one that lies on surface coordinates stays there."""
        if self.modifiers.uv_mapping:
            return self
        return replace(self, modifiers=self.modifiers.transformed(transform))


@node
class MaterialMap:
    """``material_map { ... }``: a picture's palette index chooses the texture."""

    mapping: ImageMapping
    textures: tuple[Texture, ...]
    modifiers: PatternModifiers = PLAIN

    def transformed(self, transform: Transform) -> MaterialMap:
        """The same texture, moved; one that lies on surface coordinates stays there."""
        if self.modifiers.uv_mapping:
            return self
        return replace(self, modifiers=self.modifiers.transformed(transform))


Texture: TypeAlias = PlainTexture | LayeredTexture | PatternTexture | MaterialMap
