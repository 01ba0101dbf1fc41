"""SDL: ``media { scattering { 1, 0.2 } emission 0.1 density { spherical } }``."""

from __future__ import annotations

from typing import Any, Final

from minipov.interpreter.constructs.common import (
    Field,
    boolean,
    count,
    integer,
    number,
    one_or_two_integers,
    read_all_fields,
    read_fields,
    rgb,
    unexpected,
)
from minipov.interpreter.constructs.transforms import TRANSFORM_WORDS, read_transform
from minipov.interpreter.context import Context
from minipov.interpreter.items import Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.interior import Density, Media, Scattering
from minipov.tracer.node import replace

MEDIA_FIELDS: Final[dict[str, Field]] = {
    "method": integer("method"),
    "intervals": count("intervals"),
    "samples": one_or_two_integers("samples", lambda first: first),
    "aa_threshold": number("aa_threshold"),
    "aa_level": count("aa_level", 16),
    "confidence": number("confidence"),
    "variance": number("variance"),
    "ratio": number("ratio"),
    "jitter": number("jitter"),
    "absorption": rgb("absorption"),
    "emission": rgb("emission"),
    "collect": boolean("collect"),
}
ACCEPTS: Final = (*MEDIA_FIELDS, "scattering", "density", *TRANSFORM_WORDS)
HENYEY_GREENSTEIN: Final = 5


def default_media(context: Context) -> Media:
    """The defaults, which changed with version 3.5."""
    return Media() if context.version >= 3.5 else Media(method=1, intervals=10, samples=(1, 1))


@construct(
    "media",
    signature="[identifier] [method I] [samples I, I] [absorption C] [emission C] [scattering {}] [density {}]",
    doc="Fog, smoke or fire inside an object, or everywhere.",
    accepts=ACCEPTS,
    node=Media,
)
def media(reader: ItemReader, context: Context, sink: Sink) -> Media:
    result = reader.node(Media) or default_media(context)
    while not reader.at_end:
        fields = read_fields(reader, MEDIA_FIELDS)
        if fields is not None:
            result = replace(result, **fields)
            continue
        scattering = reader.node(Scattering)
        if scattering is not None:
            result = replace(result, scattering=scattering)
            continue
        density = reader.node(Density)
        if density is not None:
            result = replace(result, densities=(*result.densities, density))
            continue
        transform = read_transform(reader, context)
        if transform is None:
            unexpected(reader, ACCEPTS)
        result = result.transformed(transform)
    return _checked(result, reader, context)


def _checked(result: Media, reader: ItemReader, context: Context) -> Media:
    changes: dict[str, Any] = {}
    if result.method not in (1, 2, 3):
        reader.refuse("media method 1, 2 or 3")
    if result.samples[1] < result.samples[0]:
        changes["samples"] = (result.samples[0], result.samples[0])
    return replace(result, **changes) if changes else result


@construct(
    "scattering",
    within=("media",),
    signature="type, color [eccentricity F] [extinction F]",
    doc="Light thrown aside by particles: 1 isotropic, 2 and 3 Mie, 4 Rayleigh, 5 Henyey-Greenstein.",
    accepts=("eccentricity", "extinction"),
    node=Scattering,
)
def scattering(reader: ItemReader, context: Context, sink: Sink) -> Scattering:
    kind = reader.integer()
    if not 1 <= kind <= HENYEY_GREENSTEIN:
        reader.refuse("a scattering type from 1 to 5")
    reader.comma()
    color = reader.rgb()
    table = {"extinction": number("extinction")}
    if kind == HENYEY_GREENSTEIN:
        table["eccentricity"] = number("eccentricity")
    return Scattering(kind, color, **read_all_fields(reader, table))
