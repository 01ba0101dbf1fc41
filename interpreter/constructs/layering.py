"""SDL: ``texture { … } texture { … }``: the textures in a row that are layers on top of each other, the lowest first.

Before version 3.5 the lower layers are seen through ``filter`` as through ``transmit``. POV-Ray changes the colours of
a pigment when it becomes a layer, those of its maps too; what the pixels of an ``image_map`` filter stays as it is.
"""

from __future__ import annotations

from typing import Final

from minipov.interpreter.context import current_context
from minipov.tracer.node import replace
from minipov.tracer.pigment import ColorMap, Pigment, PigmentBlend, PigmentList, PigmentMap
from minipov.tracer.texture import LayeredTexture, PlainTexture
from minipov.tracer.values import Rgbft

FILTERED: Final = 3.5
"""Since this version lower layers are seen through ``filter`` in the colour of the upper."""


def layers(texture: PlainTexture | LayeredTexture) -> tuple[PlainTexture, ...]:
    """The plain textures that it consists of, the lowest first."""
    return texture.layers if isinstance(texture, LayeredTexture) else (texture,)


def laid_over(below: PlainTexture | LayeredTexture, above: PlainTexture | LayeredTexture) -> LayeredTexture:
    """``above`` on top of ``below``."""
    upper = layers(above)
    if current_context().version < FILTERED:
        upper = tuple(replace(layer, pigment=_clear(layer.pigment)) for layer in upper)
    return LayeredTexture((*layers(below), *upper))


def _clear(pigment: Pigment) -> Pigment:
    """The same pigment that transmits what it filtered."""
    if pigment.pattern is None:
        return replace(pigment, color=_clear_color(pigment.color))
    return replace(pigment, blend=_clear_blend(pigment.blend))


def _clear_blend(blend: PigmentBlend | None) -> PigmentBlend | None:
    match blend:
        case ColorMap():
            return replace(blend, entries=tuple((at, _clear_color(color)) for at, color in blend.entries))
        case PigmentMap():
            return replace(blend, entries=tuple((at, _clear(pigment)) for at, pigment in blend.entries))
        case PigmentList():
            return PigmentList(tuple(_clear(pigment) for pigment in blend.pigments))
        case _:
            return blend


def _clear_color(color: Rgbft) -> Rgbft:
    red, green, blue, filtered, transmitted = color
    return red, green, blue, 0.0, filtered + transmitted
