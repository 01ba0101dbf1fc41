"""SDL: what every pattern may be followed by: ``turbulence 0.3 frequency 2 sine_wave scale 2 warp {...}``."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final, TypeVar

from minipov.interpreter.constructs.transforms import TRANSFORM_WORDS, read_transform
from minipov.interpreter.constructs.warps import TURBULENCE_FIELDS, WARP_TYPES
from minipov.interpreter.context import Context
from minipov.interpreter.reader import ItemReader
from minipov.tracer.interior import Density
from minipov.tracer.node import replace
from minipov.tracer.normal import Normal
from minipov.tracer.pattern import (
    Agate,
    Brick,
    Crackle,
    DensityFile,
    Facets,
    Fractal,
    Pattern,
    PatternModifiers,
    Pavement,
    Quilted,
    Wave,
)
from minipov.tracer.pigment import Pigment
from minipov.tracer.warp import Turbulence

Mapped = TypeVar("Mapped", Pigment, Normal, Density)

WAVES: Final[tuple[Wave, ...]] = ("ramp_wave", "triangle_wave", "sine_wave", "scallop_wave", "cubic_wave", "poly_wave")


def _noise_generator(reader: ItemReader) -> dict[str, Any]:
    number = reader.integer()
    if number not in (1, 2, 3):
        reader.refuse("noise_generator 1, 2 or 3")
    return {"noise_generator": number}


_FIELDS: Final[dict[str, Callable[[ItemReader], dict[str, Any]]]] = {
    "frequency": lambda reader: {"frequency": reader.float()},
    "phase": lambda reader: {"phase": reader.float()},
    "noise_generator": _noise_generator,
    "uv_mapping": lambda reader: {"uv_mapping": True},
}

PATTERN_MODIFIERS: Final = (*_FIELDS, *WAVES, *TURBULENCE_FIELDS, *TRANSFORM_WORDS, "warp")


def read_named(reader: ItemReader, kind: type[Mapped], base: Mapped) -> Mapped:
    """The identifier that a block may begin with, or ``base``; ``uv_mapping`` may stand before either."""
    uv_mapping = reader.word("uv_mapping")
    node = reader.node(kind) or base
    return replace(node, modifiers=replace(node.modifiers, uv_mapping=True)) if uv_mapping else node


def read_pattern_modifier(reader: ItemReader, context: Context, modifiers: PatternModifiers) -> PatternModifiers | None:
    """``modifiers`` with the next one added, or None where the next item is none."""
    transform = read_transform(reader, context)
    if transform is not None:
        return modifiers.transformed(transform)
    word = reader.word_of(_FIELDS)
    if word is not None:
        return replace(modifiers, **_FIELDS[word](reader))
    word = reader.word_of(WAVES)
    if word is not None:
        wave = WAVES[WAVES.index(word)]  # one of them, as asked for
        exponent = reader.float() if wave == "poly_wave" and reader.is_number() else 1.0
        return replace(modifiers, wave=wave, poly_exponent=exponent)
    word = reader.word_of(TURBULENCE_FIELDS)
    if word is not None:
        turbulence = modifiers.turbulence or Turbulence((0.0, 0.0, 0.0))
        return replace(modifiers, turbulence=replace(turbulence, **TURBULENCE_FIELDS[word](reader)))
    warp = reader.node(WARP_TYPES)
    if warp is not None:
        return replace(modifiers, warps=(*modifiers.warps, warp))
    return None


def _pair(reader: ItemReader) -> tuple[int, float]:
    return (reader.integer(), reader.float())


PARAMETERS: Final[dict[str, dict[type[Pattern], Callable[[ItemReader], Any]]]] = {
    "agate_turb": {Agate: ItemReader.float},
    "brick_size": {Brick: ItemReader.vector},
    "mortar": {Brick: ItemReader.float},
    "form": {Crackle: ItemReader.vector, Pavement: ItemReader.integer},
    "metric": {Crackle: ItemReader.float, Facets: ItemReader.float},
    "offset": {Crackle: ItemReader.float},
    "solid": {Crackle: lambda reader: True},
    "repeat": {Crackle: ItemReader.vector},
    "control0": {Quilted: ItemReader.float},
    "control1": {Quilted: ItemReader.float},
    "exponent": {Fractal: ItemReader.integer},
    "exterior": {Fractal: _pair, Pavement: ItemReader.integer},
    "interior": {Fractal: _pair, Pavement: ItemReader.integer},
    "interpolate": {DensityFile: ItemReader.integer},
    "coords": {Facets: ItemReader.float},
    "size": {Facets: ItemReader.float},
    "number_of_sides": {Pavement: ItemReader.integer},
    "number_of_tiles": {Pavement: ItemReader.integer},
    "pattern": {Pavement: ItemReader.integer},
}
"""Parameters that single patterns take anywhere in the block; the keyword is the field of the same name."""


def read_pattern_parameter(reader: ItemReader, pattern: Pattern | None) -> Pattern | None:
    """``pattern`` with a parameter of its own set, or None where the next item is none."""
    word = reader.word_of(PARAMETERS)
    if word is None:
        return None
    readers = PARAMETERS[word]
    if pattern is None or type(pattern) not in readers:
        owners = " and ".join(owner.__name__.lower() for owner in readers)
        reader.refuse(f"'{word}' only with a {owners} pattern")
    return replace(pattern, **{word: readers[type(pattern)](reader)})
