"""SDL: ``function { x*x + y*y - 1 }``, ``function (a, b) { ... }``, ``function { pattern { ... } }``, splines.

An expression is a tree of the small classes below; parameters are numbered. The core compiles it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, TypeAlias

from minipov.tracer.node import node
from minipov.tracer.transform import Transform

if TYPE_CHECKING:
    from minipov.tracer.pattern import Pattern, PatternModifiers
    from minipov.tracer.pigment import Pigment


@node
class Constant:
    """A number known when the function is declared."""

    value: float


@node
class Parameter:
    """Parameter number ``index`` (0-based); beyond the parameters come the running indices of ``sum`` and ``prod``."""

    index: int


@node
class Operation:
    """``operator`` is one of ``+ - * / neg < <= = != >= > & |`` or the keyword of a float function (``sin``, ...).

    Operators of two operands may have more: ``+`` of a, b and c is (a + b) + c.
    """

    operator: str
    operands: tuple[Expression, ...]


@node
class Call:
    """Another function's value; ``component`` 0..4 picks red..transmit (or x, y, z, t) of a vector function."""

    function: Function
    arguments: tuple[Expression, ...]
    component: int | None = None


@node
class Accumulate:
    """``sum(i, first, last, body)`` or ``prod(...)``; ``index`` is the parameter number that ``i`` has in ``body``."""

    operator: Literal["sum", "prod"]
    index: int
    first: Expression
    last: Expression
    body: Expression


Expression: TypeAlias = Constant | Parameter | Operation | Call | Accumulate


@node
class ExpressionFunction:
    """``function (names) { body }``; without a list the parameters are x, y, z."""

    parameters: tuple[str, ...]
    body: Expression


@node
class InternalFunction:
    """``function { internal(number) }``, number 0..78."""

    number: int


@node
class PatternFunction:
    """``function { pattern { ... } }`` of x, y, z."""

    pattern: Pattern
    modifiers: PatternModifiers


@node
class PigmentFunction:
    """``function { pigment { ... } }`` of x, y, z; five components."""

    pigment: Pigment


@node
class TransformFunction:
    """``function { transform { ... } }`` of x, y, z; three components."""

    transform: Transform


@node
class Spline:
    """``spline { cubic_spline 0, <0,0,0> 1, <1,2,3> }``: points sorted by parameter.

    ``size`` is the number of components that count (1..5); values are padded with zeros to five.
    """

    kind: Literal["linear_spline", "quadratic_spline", "cubic_spline", "natural_spline"]
    points: tuple[tuple[float, tuple[float, float, float, float, float]], ...]
    size: int


@node
class SplineFunction:
    """``function { spline { ... } }`` of one parameter; ``spline.size`` components."""

    spline: Spline


Function: TypeAlias = (
    ExpressionFunction | InternalFunction | PatternFunction | PigmentFunction | TransformFunction | SplineFunction
)
