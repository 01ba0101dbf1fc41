"""SDL: what may stand right of ``#declare X =``, in an array's braces, or as a macro's argument: one complete value.

Most are one item. A colour may be several (``rgb 1 transmit 0.5``), and textures in a row are one layered texture.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from typing import Any

from minipov.interpreter.colors import COLOR_WORDS
from minipov.interpreter.constructs.layering import laid_over
from minipov.interpreter.errors import Place, SdlError
from minipov.interpreter.items import SEMICOLON, Item, Word, complete
from minipov.interpreter.reader import ItemReader, describe
from minipov.interpreter.values import Vector, stored
from minipov.tracer.texture import LayeredTexture, MaterialMap, PatternTexture, PlainTexture, Texture

TEXTURES = (PlainTexture, LayeredTexture, PatternTexture, MaterialMap)


def rvalue(items: Sequence[Item], places: Sequence[Place], what: str, place: Place) -> Any:
    """The one value that ``items`` make; ``what`` and ``place`` say where it is needed.

    Raises:
        SdlError: they make none, or more than one.
    """
    if items and items[-1] is SEMICOLON:
        items, places = items[:-1], places[:-1]
    if len(items) == 1 and not isinstance(items[0], Word):
        return stored(complete(items[0]))
    if not items:
        raise SdlError(f"{what}: expected a value, found nothing", place)
    if isinstance(items[0], Word) and items[0].name in COLOR_WORDS:
        reader = ItemReader(what, items, places, place)
        color = Vector(reader.color())
        if not reader.at_end:
            reader.fail("the end of the colour")
        return stored(color)
    values = [complete(item) for item in items]
    if all(isinstance(value, TEXTURES) for value in values):
        return layered(values)
    at = 0 if isinstance(items[0], Word) else 1
    raise SdlError(f"{what}: expected one value, found {describe(items[at])}", places[at])


def layered(textures: Sequence[Texture]) -> Texture:
    """Textures in a row as one, the lowest first."""
    if len(textures) == 1:
        return textures[0]
    layers = [texture for texture in textures if isinstance(texture, PlainTexture | LayeredTexture)]
    if len(layers) < len(textures):
        raise SdlError("a patterned texture cannot be a layer of another")
    return reduce(laid_over, layers)
