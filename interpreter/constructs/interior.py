"""SDL: ``interior { ior 1.5 fade_distance 2 fade_power 2 media {...} }``."""

from __future__ import annotations

from typing import Final

from minipov.interpreter.constructs.common import Field, number, read_fields, rgb, unexpected
from minipov.interpreter.constructs.transforms import TRANSFORM_WORDS, read_transform
from minipov.interpreter.context import Context
from minipov.interpreter.items import Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.interior import Interior, Media
from minipov.tracer.node import replace

CAUSTIC_SHARPNESS: Final = 45.0
"""How much sharper light gathers by ``caustics`` of an interior than by that of an old finish (probed)."""

INTERIOR_FIELDS: Final[dict[str, Field]] = {
    "ior": number("ior"),
    "dispersion": number("dispersion"),
    "dispersion_samples": lambda reader: {"dispersion_samples": reader.count(1000, 2)},
    "caustics": lambda reader: {"caustics": CAUSTIC_SHARPNESS * reader.float()},
    "fade_distance": number("fade_distance"),
    "fade_power": number("fade_power"),
    "fade_color": rgb("fade_color"),
    "fade_colour": rgb("fade_color"),
}
ACCEPTS: Final = (*INTERIOR_FIELDS, "refraction", "media", *TRANSFORM_WORDS)


@construct(
    "interior",
    signature="[identifier] [ior F] [dispersion F] [caustics F] [fade_distance F fade_power F] [media {}]",
    doc="What fills an object: refraction, dispersion, attenuation and media.",
    accepts=ACCEPTS,
    node=Interior,
)
def interior(reader: ItemReader, context: Context, sink: Sink) -> Interior:
    result = reader.node(Interior) or Interior()
    while not reader.at_end:
        fields = read_fields(reader, INTERIOR_FIELDS)
        if fields is not None:
            result = replace(result, **fields)
            continue
        media = reader.node(Media)
        if media is not None:
            result = replace(result, media=(*result.media, media))
            continue
        place = reader.place
        transform = read_transform(reader, context)
        if transform is not None:
            result = result.transformed(transform)
        elif reader.word("refraction"):
            context.messages.warn_once("refraction", "'refraction' is obsolete: ior alone refracts", place)
            reader.float()
        else:
            unexpected(reader, ACCEPTS)
    return result
