"""SDL: ``rgb <1, 0.5, 0>``, ``color Red transmit 0.5``, ``red 1 green 0.5``: colours among a block's items."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from minipov.interpreter.context import current_context
from minipov.interpreter.errors import SdlError
from minipov.interpreter.values import widened
from minipov.tracer.settings import Gamma
from minipov.tracer.values import Rgbft

if TYPE_CHECKING:
    from minipov.interpreter.reader import ItemReader

_MODELS: Final = {"rgb": 3, "rgbf": 4, "rgbt": 4, "rgbft": 5, "srgb": 3, "srgbf": 4, "srgbt": 4, "srgbft": 5}
_COMPONENTS: Final = {"red": 0, "green": 1, "blue": 2, "filter": 3, "transmit": 4, "alpha": 3}
COLOR_WORDS: Final = frozenset({"color", "colour", *_MODELS, *_COMPONENTS})


def read_color(reader: ItemReader) -> Rgbft:
    """A colour at the reader's next item. Components may be any number.

    Raises:
        SdlError: no colour stands there, or an sRGB colour where no ``assumed_gamma`` was set before.
    """
    reader.comma()
    prefixed = reader.word("color", "colour") is not None
    model = reader.word_of(_MODELS)
    color = [0.0] * 5
    if model is not None:
        color = _modelled(reader, model)
    elif not reader.next_is_of(_COMPONENTS):
        given = reader.terms("a colour", 5)
        color = list(widened(given, 5))
        if not prefixed and len(given) < 5:
            return _five(color)
    while (word := reader.word_of(_COMPONENTS)) is not None:
        color[_COMPONENTS[word]] = reader.float()
    return _five(color)


def _five(color: list[float]) -> Rgbft:
    red, green, blue, filter_, transmit = color
    return (red, green, blue, filter_, transmit)


def _modelled(reader: ItemReader, model: str) -> list[float]:
    """What follows ``rgb``, ``rgbt``, ``srgb`` ..."""
    place = reader.place
    size = _MODELS[model]
    given = reader.terms("the terms of a colour", 5)
    if len(given) not in (1, size):
        current_context().messages.warn(f"'{model}' takes {size} terms, found {len(given)}", place)
    color = list(widened(given, size) if len(given) <= size else given)
    color += [0.0] * (5 - len(color))
    if model.endswith("bt"):
        color[3], color[4] = 0.0, color[3]
    if model.startswith("s"):
        context = current_context()
        if not context.scene.gamma_was_set:
            hint = "add global_settings { assumed_gamma 1 } at the top"
            raise SdlError(f"'{model}' needs an assumed_gamma before it", place, hint)
        color[:3] = [from_srgb(component, context.scene.settings.assumed_gamma) for component in color[:3]]
    return color


def from_srgb(value: float, working: Gamma) -> float:
    """An sRGB component in the working space (the curve of IEC 61966-2-1)."""
    if working == "srgb" or working is None:
        return value
    linear = value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4
    return linear if working == 1.0 else linear ** (1.0 / working)
