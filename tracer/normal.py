"""SDL: ``normal { bumps 0.5 scale 0.1 }``: bumps painted on a surface."""

from __future__ import annotations

from typing import TypeAlias

from minipov.tracer.node import node, replace
from minipov.tracer.pattern import PLAIN, Pattern, PatternModifiers
from minipov.tracer.transform import IDENTITY, Transform
from minipov.tracer.values import Vec2


@node
class SlopeMap:
    """``slope_map { [F <height, slope>] ... }``."""

    entries: tuple[tuple[float, Vec2], ...]


@node
class NormalMap:
    """``normal_map { [F normal] ... }``; the numbers are weights under ``average``."""

    entries: tuple[tuple[float, Normal], ...]


@node
class NormalList:
    """The normals of a block pattern, one per kind of block; None leaves that block smooth."""

    normals: tuple[Normal | None, ...]


NormalBlend: TypeAlias = SlopeMap | NormalMap | NormalList


@node
class Normal:
    """A perturbation of the surface normal; ``pattern`` None leaves it alone.

    ``accuracy`` is the distance of the samples from which a gradient is estimated, in units of the pattern.
    """

    pattern: Pattern | None
    amount: float = 0.5
    blend: NormalBlend | None = None
    modifiers: PatternModifiers = PLAIN
    accuracy: float = 0.02
    no_bump_scale: bool = False

    def transformed(self, transform: Transform) -> Normal:
        """The same normal, moved; one that lies on surface coordinates stays there."""
        if transform is IDENTITY or self.modifiers.uv_mapping:
            return self
        return replace(self, modifiers=self.modifiers.transformed(transform))
