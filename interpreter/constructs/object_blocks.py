"""SDL: modifiers of objects that are not looks: ``photons { target }``, ``radiosity { importance 1 }``."""

from __future__ import annotations

from typing import Final

from minipov.interpreter.constructs.common import Field, boolean, read_all_fields, required_boolean
from minipov.interpreter.context import Context
from minipov.interpreter.items import Block, Sink
from minipov.interpreter.reader import ItemReader
from minipov.interpreter.registry import construct

PHOTON_FIELDS: Final[dict[str, Field]] = {
    "target": lambda reader: {"target": reader.float() if reader.is_number() else 1.0},
    "refraction": required_boolean("refraction"),
    "reflection": required_boolean("reflection"),
    "collect": boolean("collect"),
    "pass_through": boolean("pass_through"),
}


@construct(
    "photons",
    signature="[target [F]] [refraction B] [reflection B] [collect B] [pass_through B]",
    doc="How an object takes part in photon mapping.",
    accepts=tuple(PHOTON_FIELDS),
)
def photons(reader: ItemReader, context: Context, sink: Sink) -> Block:
    return Block("photons", read_all_fields(reader, PHOTON_FIELDS))


@construct(
    "radiosity",
    signature="importance F",
    doc="How densely an object is looked at by radiosity: above 0, at most 1.",
    accepts=("importance",),
)
def object_radiosity(reader: ItemReader, context: Context, sink: Sink) -> Block:
    if not reader.word("importance"):
        reader.fail("'importance'")
    importance = reader.float()
    if not 0.0 < importance <= 1.0:
        reader.refuse("an importance above 0 and at most 1")
    return Block("radiosity", importance)
