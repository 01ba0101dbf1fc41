"""What the keyword table and the constructs say about a word, in the words of an editor."""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from typing import Any, Final

import minipov.interpreter.constructs  # noqa: F401  # enters the constructs into their table
from minipov.grammar.keywords import KEYWORDS, Kind
from minipov.interpreter import registry
from minipov.interpreter.colors import COLOR_WORDS
from minipov.interpreter.registry import Construct
from minipov.interpreter.values import COMPONENTS

BLOCKS: Final = registry.names()
"""The words that begin a block somewhere."""

MEMBERS: Final = (*COMPONENTS, "gray")
"""What may follow a period."""

SCENE_TYPES: Final = frozenset({"Camera", "LightSource", "Fog", "Rainbow", "SkySphere", "Media"})


def _yields(construct: Construct) -> tuple[str, ...]:
    """The types of what a block is worth."""
    return tuple(str(construct.read.__annotations__.get("return", "")).split(" | "))


OBJECTS: Final = frozenset(c.name for c in registry.constructs() if not c.within and "Object" in _yields(c))
"""The blocks that are objects."""

_PARTS: Final = frozenset(word for c in registry.constructs() for word in c.accepts)

SCENE: Final = frozenset(
    c.name
    for c in registry.constructs()
    if not c.within and (c.name in OBJECTS or SCENE_TYPES.intersection(_yields(c)) or c.name not in _PARTS)
) - {"#default", "spline"}
"""The blocks that may stand by themselves in a file."""


def block(path: tuple[str, ...]) -> Construct | None:
    """The construct of the innermost of the open blocks, the outermost first; an entry ``[`` reads as its map does."""
    *outer, name = path or ("",)
    while name == "[" and outer:
        name = outer.pop()
    return registry.find(name, outer[-1] if outer else "")


_FOLLOWERS: Final = {"density_file": {"df3"}, "charset": {"ascii", "utf8", "sys"}}
"""Words that may only follow another word."""


def accepted(path: tuple[str, ...]) -> frozenset[str]:
    """The keywords that may stand in the innermost of the open blocks; empty where that is not known."""
    if not path:
        return SCENE
    construct = block(path)
    if construct is None:
        return frozenset()
    words = {*construct.accepts}
    if "object" in construct.signature:
        words |= OBJECTS | {"light_source"}
    if construct.name in {"texture", "pigment", "normal", "density"}:
        words.add(construct.name)
    for word, followers in _FOLLOWERS.items():
        if word in words:
            words |= followers
    if takes_color(path):
        words |= COLOR_WORDS
    return frozenset(words)


def takes_color(path: tuple[str, ...]) -> bool:
    """Whether a colour is likely to stand in the innermost of the open blocks."""
    construct = block(path)
    if construct is None:
        return False
    return "color" in construct.signature or "rgb" in construct.accepts or path[-1] == "["


def is_pattern_list(path: tuple[str, ...]) -> bool:
    """Whether the innermost of the open blocks is a pattern's list of what it chooses from."""
    construct = block(path)
    return construct is not None and construct.name == "object" and bool(construct.within)


def is_color_word(word: str) -> bool:
    """Whether a keyword begins a colour or is a part of one."""
    return word in COLOR_WORDS


def homes(word: str) -> list[str]:
    """The blocks in which a keyword may stand."""
    return sorted({c.name for c in registry.constructs() if word in c.accepts})


_PLAIN: Final = (bool, float, int, str, tuple)


def defaults(construct: Construct) -> dict[str, Any]:
    """What holds where a keyword of the block is not said: the fields of the node that the block makes."""
    node = construct.node
    if node is None or not is_dataclass(node):
        return {}
    return {field.name: field.default for field in fields(node) if isinstance(field.default, _PLAIN)}


def is_callable(word: str) -> bool:
    """Whether a keyword is a function."""
    return word in KEYWORDS and KEYWORDS[word].kind in {Kind.FUNCTION, Kind.UNARY_FUNCTION}
