"""SDL: ``global_settings { assumed_gamma 1 max_trace_level 10 radiosity {...} photons {...} }``."""

from __future__ import annotations

from typing import Any, Final

from minipov.interpreter.constructs.common import Field, count, integer, number, read_fields, rgb, text, unexpected
from minipov.interpreter.constructs.image_maps import read_gamma
from minipov.interpreter.context import Context
from minipov.interpreter.errors import Place
from minipov.interpreter.items import Block, Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct
from minipov.tracer.node import replace
from minipov.tracer.settings import GlobalSettings, Photons, Radiosity, SubsurfaceSettings

LARGEST_TRACE_LEVEL: Final = 256
MOST_RAYS: Final = 10_000


def _noise_generator(reader: ItemReader) -> dict[str, Any]:
    value = reader.integer()
    if value not in (1, 2, 3):
        reader.refuse("noise_generator 1, 2 or 3")
    return {"noise_generator": value}


SETTINGS_FIELDS: Final[dict[str, Field]] = {
    "adc_bailout": number("adc_bailout"),
    "ambient_light": rgb("ambient_light"),
    "assumed_gamma": lambda reader: {"assumed_gamma": read_gamma(reader)},
    "irid_wavelength": rgb("irid_wavelength"),
    "max_trace_level": integer("max_trace_level"),
    "mm_per_unit": number("mm_per_unit"),
    "noise_generator": _noise_generator,
    "number_of_waves": integer("number_of_waves"),
}
OBSOLETE: Final[dict[str, Field]] = {
    "hf_gray_16": lambda reader: {"hf_gray_16": reader.boolean()},
    "max_intersections": integer("max_intersections"),
}
CHARSETS: Final = ("ascii", "utf8", "sys")
BLOCKS: Final[dict[str, type]] = {"radiosity": Radiosity, "photons": Photons, "subsurface": SubsurfaceSettings}
ACCEPTS: Final = (*SETTINGS_FIELDS, *OBSOLETE, "charset", *BLOCKS)


@construct(
    "global_settings",
    signature="[assumed_gamma F|srgb] [max_trace_level I] [ambient_light C] [radiosity {}] [photons {}] ...",
    doc="What holds for the whole scene.",
    accepts=ACCEPTS,
    node=GlobalSettings,
)
def global_settings(reader: ItemReader, context: Context, sink: Sink) -> Block:
    scene = context.scene
    while not reader.at_end:
        place = reader.place
        fields = read_fields(reader, SETTINGS_FIELDS)
        if fields is not None:
            scene.settings = replace(scene.settings, **_checked(fields, context, place))
            continue
        unused = read_fields(reader, OBSOLETE)
        if unused is not None:
            (word,) = unused
            context.messages.warn_once(word, f"'{word}' has had no effect since version 3.7", place)
            continue
        if reader.word("charset"):
            scene.charset = reader.word(*CHARSETS) or reader.fail(f"one of {', '.join(CHARSETS)}")
            continue
        said: dict[str, Any] = {word: value for word, kind in BLOCKS.items() if (value := reader.node(kind))}
        if not said:
            unexpected(reader, ACCEPTS)
        scene.settings = replace(scene.settings, **said)
    return Block("global_settings", None)


def _checked(fields: dict[str, Any], context: Context, place: Place) -> dict[str, Any]:
    """Limits; and the first ``assumed_gamma`` counts."""
    if "assumed_gamma" in fields:
        if context.scene.gamma_was_set:
            if fields["assumed_gamma"] != context.scene.settings.assumed_gamma:
                context.messages.warn("assumed_gamma was set before: the first value counts", place)
            return {}
        context.scene.gamma_was_set = True
    if "noise_generator" in fields:
        context.scene.noise_was_set = True
    level = fields.get("max_trace_level")
    if level is not None and not 1 <= level <= LARGEST_TRACE_LEVEL:
        context.messages.warn(f"max_trace_level must be 1 to {LARGEST_TRACE_LEVEL}", place)
        return {"max_trace_level": min(max(level, 1), LARGEST_TRACE_LEVEL)}
    if fields.get("number_of_waves", 1) <= 0:
        context.messages.warn("number_of_waves must be above 0: taken as 1", place)
        return {"number_of_waves": 1}
    return fields


def _positive(field: str) -> Field:
    def read(reader: ItemReader) -> dict[str, Any]:
        place_value = reader.float()
        if place_value <= 0.0:
            reader.refuse(f"a {field} above 0")
        return {field: place_value}

    return read


def _switch_with_value(field: str) -> Field:
    return lambda reader: {field: reader.float() != 0.0}


def _count(reader: ItemReader) -> dict[str, Any]:
    first = reader.count(MOST_RAYS)
    return {"count": (first, max(first, reader.count()) if reader.is_number() else max(first, 1600))}


def _nearest_count(reader: ItemReader) -> dict[str, Any]:
    first = min(max(reader.integer(), 1), 20)
    return {"nearest_count": (first, reader.count() if reader.is_number() else 0)}


def _recursion_limit(reader: ItemReader) -> dict[str, Any]:
    return {"recursion_limit": min(max(reader.integer(), 1), 20)}


RADIOSITY_FIELDS: Final[dict[str, Field]] = {
    "adc_bailout": _positive("adc_bailout"),
    "always_sample": _switch_with_value("always_sample"),
    "brightness": _positive("brightness"),
    "count": _count,
    "error_bound": _positive("error_bound"),
    "gray_threshold": number("gray_threshold"),
    "low_error_factor": _positive("low_error_factor"),
    "max_sample": number("max_sample"),
    "maximum_reuse": _positive("maximum_reuse"),
    "minimum_reuse": number("minimum_reuse"),
    "nearest_count": _nearest_count,
    "normal": _switch_with_value("normal"),
    "media": _switch_with_value("media"),
    "subsurface": _switch_with_value("subsurface"),
    "brilliance": _switch_with_value("brilliance"),
    "pretrace_start": _positive("pretrace_start"),
    "pretrace_end": _positive("pretrace_end"),
    "recursion_limit": _recursion_limit,
}
SAVE_AND_LOAD: Final[dict[str, Field]] = {"save_file": text("save_file"), "load_file": text("load_file")}


@construct(
    "radiosity",
    within=("global_settings",),
    signature="[count I] [error_bound F] [recursion_limit I] [pretrace_start F] [pretrace_end F] ...",
    doc="Light that surfaces throw on each other.",
    accepts=(*RADIOSITY_FIELDS, *SAVE_AND_LOAD),
    node=Radiosity,
)
def radiosity(reader: ItemReader, context: Context, sink: Sink) -> Radiosity:
    said: dict[str, Any] = {}
    base = reader.node(Radiosity) or Radiosity()
    while not reader.at_end:
        place = reader.place
        fields = read_fields(reader, RADIOSITY_FIELDS)
        if fields is not None:
            said.update(fields)
        elif read_fields(reader, SAVE_AND_LOAD) is not None:
            context.messages.warn_once("radiosity files", "radiosity files belong on the command line: ignored", place)
        else:
            unexpected(reader, (*RADIOSITY_FIELDS, *SAVE_AND_LOAD))
    return _with_fitting_reuse(replace(base, **said), said, reader)


def _with_fitting_reuse(found: Radiosity, said: dict[str, Any], reader: ItemReader) -> Radiosity:
    """minimum_reuse stays at most half of maximum_reuse where only one of them is given."""
    if "minimum_reuse" in said and "maximum_reuse" in said:
        if found.minimum_reuse >= found.maximum_reuse:
            reader.refuse("a minimum_reuse below maximum_reuse")
    elif found.minimum_reuse > found.maximum_reuse / 2.0:
        if "minimum_reuse" in said:
            return replace(found, maximum_reuse=found.minimum_reuse * 2.0)
        return replace(found, minimum_reuse=found.maximum_reuse / 2.0)
    return found


def _photon_radius(reader: ItemReader) -> dict[str, Any]:
    """``[F], [F], [F], [F]``, each of which may be left out."""
    values: list[float | None] = []
    while len(values) < 4 and (reader.is_number() or reader.next_is_comma()):
        values.append(reader.float() if reader.is_number() and not reader.next_is_comma() else None)
        reader.comma()
    values += [None] * (4 - len(values))
    a, b, c, d = values
    return {"radius": (a, 1.0 if b is None else b, c, 1.0 if d is None else d)}


PHOTON_FIELDS: Final[dict[str, Field]] = {
    "spacing": number("spacing"),
    "count": lambda reader: {"count": reader.count(), "spacing": None},
    "gather": lambda reader: {"gather": (reader.count(), reader.count())},
    "media": lambda reader: {"media": (reader.count(), reader.float() if reader.is_number() else 1.0)},
    "jitter": number("jitter"),
    "max_trace_level": count("max_trace_level", LARGEST_TRACE_LEVEL),
    "adc_bailout": number("adc_bailout"),
    "autostop": number("autostop"),
    "expand_thresholds": lambda reader: {"expand_thresholds": (reader.float(), reader.count())},
    "radius": _photon_radius,
    "save_file": text("save_file"),
    "load_file": text("load_file"),
}


@construct(
    "photons",
    within=("global_settings",),
    signature="spacing F | count I [gather I, I] [media I [, F]] [autostop F] [jitter F] ...",
    doc="Caustics by photons shot from the lights.",
    accepts=tuple(PHOTON_FIELDS),
    node=Photons,
)
def photons(reader: ItemReader, context: Context, sink: Sink) -> Photons:
    said: dict[str, Any] = {}
    while not reader.at_end:
        fields = read_fields(reader, PHOTON_FIELDS)
        if fields is None:
            unexpected(reader, PHOTON_FIELDS)
        said.update(fields)
    if "save_file" in said and "load_file" in said:
        reader.refuse("save_file or load_file, not both")
    return Photons(**said)


@construct(
    "subsurface",
    within=("global_settings",),
    signature="[samples I, I] [radiosity B]",
    doc="Switches subsurface light transport on.",
    accepts=("samples", "radiosity"),
    node=SubsurfaceSettings,
)
def subsurface(reader: ItemReader, context: Context, sink: Sink) -> SubsurfaceSettings:
    said: dict[str, Any] = {}
    table: dict[str, Field] = {
        "samples": lambda r: {"samples": (r.count(10_000), r.count(10_000))},
        "radiosity": lambda r: {"radiosity": r.boolean()},
    }
    while not reader.at_end:
        fields = read_fields(reader, table)
        if fields is None:
            unexpected(reader, table)
        said.update(fields)
    return SubsurfaceSettings(**said)
