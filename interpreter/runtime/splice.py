"""SDL: ``#macro S(a, b) a + b #end`` ... ``2*S(1, 2)`` is 4: a macro's result where an operand stands.

A macro's body replaces its call, as text does. So what it leaves keeps its open terms: ``a + b`` is three tokens, and
``2*`` before them makes five, worked out when no more can join. What is left may also be several items, or none.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any, Final

import numpy as np
from minipov.interpreter.errors import SdlError
from minipov.interpreter.items import Punctuation, Word
from minipov.interpreter.runtime.operators import divide, negate, not_
from minipov.interpreter.values import COMPONENTS, Vector, kind_of

PLUS: Final = Punctuation("+")
MINUS: Final = Punctuation("-")
TIMES: Final = Punctuation("*")
OVER: Final = Punctuation("/")
NOT: Final = Punctuation("!")
_SIGNS: Final = {PLUS, MINUS, NOT}


class Spliced:
    """Tokens of an expression that more may join: values, the signs above, and other items between them."""

    __slots__ = ("tokens",)

    def __init__(self, tokens: list[Any]) -> None:
        self.tokens = tokens

    def items(self) -> list[Any]:
        """The items that the tokens make, every sum worked out."""
        return list(_worked_out(self.tokens))

    def value(self) -> Any:
        """The one value that the tokens make.

        Raises:
            SdlError: there are several, or none.
        """
        items = self.items()
        if len(items) != 1:
            raise SdlError(f"expected one value, but the macro gives {len(items) or 'none'}")
        return items[0]

    def __add__(self, other: Any) -> Spliced:
        return Spliced([*self.tokens, PLUS, *_tokens(other)])

    def __radd__(self, other: Any) -> Spliced:
        return Spliced([*_tokens(other), PLUS, *self.tokens])

    def __sub__(self, other: Any) -> Spliced:
        return Spliced([*self.tokens, MINUS, *_tokens(other)])

    def __rsub__(self, other: Any) -> Spliced:
        return Spliced([*_tokens(other), MINUS, *self.tokens])

    def __mul__(self, other: Any) -> Spliced:
        return Spliced([*self.tokens, TIMES, *_tokens(other)])

    def __rmul__(self, other: Any) -> Spliced:
        return Spliced([*_tokens(other), TIMES, *self.tokens])

    def __truediv__(self, other: Any) -> Spliced:
        return Spliced([*self.tokens, OVER, *_tokens(other)])

    def __rtruediv__(self, other: Any) -> Spliced:
        return Spliced([*_tokens(other), OVER, *self.tokens])

    def __neg__(self) -> Spliced:
        return Spliced([MINUS, *self.tokens])

    def __pos__(self) -> Spliced:
        return Spliced([PLUS, *self.tokens])

    def inverted(self) -> Spliced:
        """``!`` before it."""
        return Spliced([NOT, *self.tokens])

    def __lt__(self, other: Any) -> Any:
        return value_of(self) < value_of(other)

    def __gt__(self, other: Any) -> Any:
        return value_of(self) > value_of(other)

    def __getattr__(self, name: str) -> Any:
        """A component of the last value, if ``name`` is one of SDL's."""
        if (name in COMPONENTS or name == "gray") and self.tokens:
            return Spliced([*self.tokens[:-1], getattr(self.tokens[-1], name)])
        raise AttributeError(name)


def value_of(operand: Any) -> Any:
    """An operand where exactly one value must stand."""
    return operand.value() if operand.__class__ is Spliced else operand


def items_of(operand: Any) -> list[Any]:
    """An operand where any number of items may stand."""
    return operand.items() if operand.__class__ is Spliced else [operand]


def joined(operands: Iterable[Any]) -> list[Any]:
    """The items that operands in a row make: ``5 M()`` is one sum if M's body is ``+ 1``."""
    return list(_worked_out([token for operand in operands for token in _tokens(operand)]))


def _tokens(operand: Any) -> list[Any]:
    if isinstance(operand, np.ndarray):  # a long run of literal vectors
        return [Vector(row) for row in operand.tolist()]
    return operand.tokens if operand.__class__ is Spliced else [operand]


def _worked_out(tokens: list[Any]) -> Iterator[Any]:
    at = 0
    while at < len(tokens):
        token = tokens[at]
        if isinstance(token, float | int | Vector) or token in _SIGNS:
            value, at = _sum(tokens, at)
            yield value
        else:
            if token is TIMES or token is OVER:
                raise SdlError(f"expected a value before '{token.text}'")
            yield token
            at += 1


def _sum(tokens: list[Any], at: int) -> tuple[Any, int]:
    value, at = _product(tokens, at)
    while at < len(tokens) and (tokens[at] is PLUS or tokens[at] is MINUS):
        term, following = _product(tokens, at + 1)
        value = value + term if tokens[at] is PLUS else value - term
        at = following
    return value, at


def _product(tokens: list[Any], at: int) -> tuple[Any, int]:
    value, at = _factor(tokens, at)
    while at < len(tokens) and (tokens[at] is TIMES or tokens[at] is OVER):
        factor, following = _factor(tokens, at + 1)
        value = value * factor if tokens[at] is TIMES else divide(value, factor)
        at = following
    return value, at


_UNARY: Final[dict[Punctuation, Callable[[Any], Any]]] = {PLUS: lambda value: value, MINUS: negate, NOT: not_}


def _factor(tokens: list[Any], at: int) -> tuple[Any, int]:
    if at >= len(tokens):
        raise SdlError("expected a value after the operator")
    token = tokens[at]
    if isinstance(token, Punctuation) and token in _UNARY:
        value, at = _factor(tokens, at + 1)
        return _UNARY[token](value), at
    if isinstance(token, Word | Punctuation):
        raise SdlError(f"expected a value, found {token.name if isinstance(token, Word) else token.text!r}")
    if not isinstance(token, float | int | Vector):
        raise SdlError(f"{kind_of(token)} cannot be computed with")
    return token, at + 1
