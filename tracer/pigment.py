"""SDL: ``pigment { bozo color_map { [0 rgb 0] [1 rgb 1] } scale 2 }``."""

from __future__ import annotations

from typing import TypeAlias

from minipov.tracer.function import Function
from minipov.tracer.node import node, replace
from minipov.tracer.pattern import PLAIN, Pattern, PatternModifiers
from minipov.tracer.transform import IDENTITY, Transform
from minipov.tracer.values import OPAQUE_BLACK, Rgbft


@node
class ColorMap:
    """``color_map { [F color] ... }``; 3.8: ``blend_mode`` 0..3 and ``blend_gamma``."""

    entries: tuple[tuple[float, Rgbft], ...]
    blend_mode: int = 0
    blend_gamma: float = 2.5


@node
class PigmentMap:
    """``pigment_map { [F pigment] ... }``; the numbers are weights under ``average``."""

    entries: tuple[tuple[float, Pigment], ...]
    blend_mode: int = 0
    blend_gamma: float = 2.5


@node
class PigmentList:
    """The pigments (or plain colours) of ``checker``, ``brick``, ``hexagon``, ... one per kind of block."""

    pigments: tuple[Pigment, ...]


@node
class UserDefinedPigment:
    """3.8 ``user_defined { function{} ... }``: a function (or None) each for red, green, blue, filter, transmit."""

    functions: tuple[Function | None, ...]


PigmentBlend: TypeAlias = ColorMap | PigmentMap | PigmentList | UserDefinedPigment


@node
class Pigment:
    """A colour at every point of space.

    Without a ``pattern`` it is ``color`` everywhere. With one, the pattern's value looks up ``blend``; None means the
    pattern's own default map. An `ImageMap` has its colours itself.
    """

    color: Rgbft = OPAQUE_BLACK
    pattern: Pattern | None = None
    blend: PigmentBlend | None = None
    modifiers: PatternModifiers = PLAIN
    quick_color: Rgbft | None = None

    def transformed(self, transform: Transform) -> Pigment:
        """The same pigment, moved; one that lies on surface coordinates stays there."""
        plain = self.pattern is None and self.blend is None
        if transform is IDENTITY or plain or self.modifiers.uv_mapping:
            return self
        return replace(self, modifiers=self.modifiers.transformed(transform))
