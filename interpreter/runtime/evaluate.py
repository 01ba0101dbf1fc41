"""SDL: ``F(x, y, z)`` outside functions: the value of a function or spline while the scene is read."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final, Literal

from minipov.interpreter.context import current_context
from minipov.interpreter.errors import SdlError
from minipov.interpreter.items import FunctionImage, Sink, Word, complete
from minipov.interpreter.runtime.splines import evaluate
from minipov.interpreter.values import Vector, kind_of
from minipov.tracer import _core
from minipov.tracer.function import (
    Accumulate,
    Call,
    Constant,
    Expression,
    ExpressionFunction,
    Function,
    InternalFunction,
    Operation,
    PatternFunction,
    PigmentFunction,
    Spline,
    SplineFunction,
    TransformFunction,
)
from minipov.tracer.pigment import Pigment
from minipov.tracer.transform import Transform

FUNCTIONS = (
    ExpressionFunction,
    InternalFunction,
    PatternFunction,
    PigmentFunction,
    TransformFunction,
    SplineFunction,
)
_COMPONENTS = {PigmentFunction: 5, TransformFunction: 3}
_HIGH: Final = 0.996093
_WEIGHTS: Final = {-1: (0.297, 0.589, 0.114), -2: (_HIGH, _HIGH / 255.0, 0.0)}
"""Of red, green and blue; ``hf`` is the height that a height field takes from them."""


def call_function(callee: Any, values: Sequence[Any]) -> Any:
    """The value of a function or spline.

    Raises:
        SdlError: ``callee`` is neither, or the number of arguments is wrong.
    """
    if isinstance(callee, Spline):
        kind = values[1].name if len(values) == 2 and isinstance(values[1], Word) else None
        if len(values) != 1 and kind is None:
            raise SdlError(f"a spline takes one argument, found {len(values)}")
        return evaluate(callee, values[0], kind)
    if not isinstance(callee, FUNCTIONS):
        raise SdlError(f"{kind_of(callee)} cannot be called", hint="only macros, functions and splines can")
    value = compiled_function(callee)(*expand(callee, values))
    return Vector(value) if isinstance(value, tuple) else value


def parameter_count(function: Function) -> int | None:
    """How many arguments a function takes; None if only the core knows."""
    if isinstance(function, ExpressionFunction):
        return len(function.parameters)
    if isinstance(function, InternalFunction):
        return None
    return 1 if isinstance(function, SplineFunction) else 3


def expand(function: Function, values: Sequence[Any]) -> tuple[float, ...]:
    """The arguments as floats."""
    count = parameter_count(function)
    if count is not None and len(values) != count:
        raise SdlError(f"the function takes {count} argument{'s' * (count != 1)}, found {len(values)}")
    for value in values:
        if not isinstance(value, float | int):
            raise SdlError(f"the arguments of a function are numbers, not {kind_of(value)}")
    return tuple(values)


_cache: dict[int, tuple[Function, Any, int | None]] = {}


def called_before(callee: Any, count: int) -> Any:
    """The core's function, if it was made before and takes so many arguments; else None."""
    known = _cache.get(id(callee))
    return known[1] if known is not None and known[0] is callee and known[2] in (count, None) else None


def compiled_function(function: Function) -> Any:
    """The core's function, made once."""
    known = _cache.get(id(function))
    if known is not None and known[0] is function:
        return known[1]
    try:
        context = current_context()
        compiled = _core.Function(function, context.noise_generator, context.scene.settings.number_of_waves)
    except (ValueError, RecursionError) as error:
        raise SdlError(str(error)) from None
    _cache[id(function)] = (function, compiled, parameter_count(function))
    return compiled


def result_size(function: Function) -> int:
    """How many components a function's value has."""
    if isinstance(function, SplineFunction):
        return function.spline.size
    return _COMPONENTS.get(type(function), 1)


# --- building the trees of functions ---


def captured(value: Any) -> Constant:
    """A variable in a function's body: its value now."""
    if isinstance(value, float | int):
        return Constant(float(value))
    hint = "a vector can stand in a function only by its components, kept in variables of their own"
    raise SdlError(
        f"expected a number in the function, found {kind_of(value)}", hint=hint if isinstance(value, Vector) else None
    )


def function_call(callee: Any, arguments: tuple[Expression, ...], component: int | None) -> Expression:
    """A function or spline called in a function's body; ``component`` is as `component_number` has it."""
    if isinstance(callee, Spline):
        callee = SplineFunction(callee)
    if not isinstance(callee, FUNCTIONS):
        raise SdlError(f"{kind_of(callee)} cannot be called in a function")
    count = parameter_count(callee)
    if count is not None and len(arguments) != count:
        raise SdlError(f"the function takes {count} argument{'s' * (count != 1)}, found {len(arguments)}")
    size = result_size(callee)
    if component is None:
        if size > 1:
            raise SdlError("this function gives a vector: add a component, such as .x or .red")
        return Call(callee, arguments)
    if component >= size:
        raise SdlError(f"the function's value has {size} components")
    if component in _WEIGHTS:
        red, green, blue = (
            Operation("*", (Constant(weight), Call(callee, arguments, number)))
            for number, weight in enumerate(_WEIGHTS[component])
        )
        return Operation("+", (Operation("+", (red, green)), blue))
    return Call(callee, arguments, component)


def accumulate(
    operator: Literal["sum", "prod"], index: int, first: Expression, last: Expression, body: Expression
) -> Accumulate:
    """``sum(i, first, last, body)`` or ``prod(...)``."""
    if isinstance(first, Constant) and isinstance(last, Constant) and last.value - first.value > _core.MOST_TURNS:
        raise SdlError(f"{operator}() from {first.value:g} to {last.value:g} would never end")
    return Accumulate(operator, index, first, last, body)


def internal_function(number: float) -> InternalFunction:
    """``function { internal(N) }``."""
    if not 0 <= int(number) <= 78:
        raise SdlError(f"there is no internal function {number:g}", hint="they are numbered 0 to 78")
    return InternalFunction(int(number))


def block_function(sink: Sink) -> Function:
    """``function { pattern {...} }``, ``pigment``, ``transform`` or ``spline``: what the block inside gave."""
    value = complete(sink.items[0]) if sink.items else None
    if isinstance(value, FUNCTIONS):
        return value
    if isinstance(value, Pigment):
        return PigmentFunction(value)
    if isinstance(value, Transform):
        return TransformFunction(value)
    if isinstance(value, Spline):
        return SplineFunction(value)
    raise SdlError(f"{kind_of(value)} cannot be a function", sink.place)


def sized_function(width: float, height: float, function: Function) -> FunctionImage:
    """``function W, H { ... }``."""
    if int(width) < 1 or int(height) < 1:
        raise SdlError(f"an image of {width:g} by {height:g} pixels is impossible")
    return FunctionImage(int(width), int(height), function)
