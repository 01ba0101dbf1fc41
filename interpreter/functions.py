"""SDL: what may stand in ``function (x, y) { ... }``: its parameters, the language's own functions, components."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from minipov.interpreter.values import COMPONENTS

DEFAULT_PARAMETERS: Final = ("x", "y", "z")
_ALIASES: Final = {"u": "x", "v": "y"}
_UNARY_FUNCTIONS: Final = (
    "abs", "acos", "acosh", "asin", "asinh", "atan", "atanh", "ceil", "cos", "cosh", "degrees", "exp", "floor", "int",
    "ln", "log", "radians", "sin", "sinh", "sqrt", "tan", "tanh",
)  # fmt: skip
FLOAT_FUNCTIONS: Final = {
    **dict.fromkeys(_UNARY_FUNCTIONS, (1, 1)),
    **dict.fromkeys(("atan2", "mod", "pow"), (2, 2)),
    **dict.fromkeys(("max", "min"), (1, 99)),
    "select": (3, 4),
}
"""The functions that may stand in a function's body, and how many arguments they take."""

_MIXTURES: Final = {"gray": -1, "grey": -1, "hf": -2}


def parameter_numbers(parameters: Sequence[str] | None) -> dict[str, int]:
    """The number of every name that a function's parameters have; None stands for x, y, z."""
    scope = {name: number for number, name in enumerate(DEFAULT_PARAMETERS if parameters is None else parameters)}
    return scope if parameters is not None else scope | {alias: scope[name] for alias, name in _ALIASES.items()}


def component_number(name: str) -> int:
    """The number of a component in a function's body: from 0, or below 0 for a mixture of them."""
    return _MIXTURES.get(name, COMPONENTS.get(name, 9))
