"""The names that compiled code uses, other than SDL's own: one table, filled for each run."""

from __future__ import annotations

from functools import partial
from typing import Any

from minipov.interpreter.arrays import UNSET, Array, Dictionary, copied, subscript
from minipov.interpreter.errors import Place, SdlError
from minipov.interpreter.items import Item, Punctuation, Sink, Word
from minipov.interpreter.runtime import calls, dictionaries, evaluate, operators, pending, splice  # noqa: F401
from minipov.interpreter.runtime.builtins import BUILTINS
from minipov.interpreter.runtime.function_text import FunctionTexts, any_macro, named
from minipov.interpreter.runtime.macros import MISSING, Macro
from minipov.interpreter.runtime.names import Cell, FixedCell, Symbol, global_cell
from minipov.interpreter.runtime.program import Running
from minipov.interpreter.values import EPSILON, Vector, kind_of, stored
from minipov.tracer import function

_PLAIN: dict[str, Any] = {
    **{name: getattr(calls, name) for name in (
        "fail", "call", "call_with", "member", "element", "holds", "call_gathered", "call_spread", "builtin_spread",
        "builtin_gathered", "rvalue_of", "rvalue_in", "values_in_call", "vector", "vector3", "separated_vector",
        "spliced_vector", "gathered_vector", "gathered_value",
    )},
    **{name: getattr(operators, name) for name in (
        "divide", "not_", "equal", "unequal", "less_equal", "greater_equal", "both", "either", "choose", "truth",
    )},
    **{name: getattr(splice, name) for name in ("Spliced", "value_of", "PLUS", "MINUS", "TIMES", "OVER", "NOT")},
    **{name: getattr(evaluate, name) for name in (
        "accumulate", "captured", "function_call", "internal_function", "block_function", "sized_function",
    )},
    "ExpressionFunction": function.ExpressionFunction,
    "Constant": function.Constant,
    "Parameter": function.Parameter,
    "Operation": function.Operation,
    "Cell": Cell,
    "FixedCell": FixedCell,
    "Dictionary": Dictionary,
    "MISSING": MISSING,
    "global_cell": global_cell,
    "Macro": Macro,
    "any_macro": any_macro,
    "named": named,
    "UNSET": UNSET,
    "copied": copied,
    "float": float,
    "part": pending.part,
    "stored": stored,
    "subscript": subscript,
    "undefine": Symbol.undefine,
}  # fmt: skip


def is_case(value: Any, wanted: Any) -> bool:
    """``#case``."""
    return bool(abs(value - wanted) < EPSILON)


def in_range(value: float, low: float, high: float) -> bool:
    """``#range``."""
    return low - EPSILON <= value <= high + EPSILON


def loop_step(step: Any) -> float:
    """The step of ``#for``, which must not be zero."""
    if not isinstance(step, float | int):
        raise SdlError(f"the step of #for is a number, not {kind_of(step)}")
    if abs(step) < EPSILON:
        raise SdlError("the step of #for is zero: the loop would never end")
    return step


def loop_goes_on(value: float, end: float, step: float) -> bool:
    """Whether ``#for`` makes another turn."""
    return value < end + EPSILON if step > 0 else value > end - EPSILON


def array(sizes: tuple[Any, ...], mixed: bool) -> Array:
    """``array[n][m]``."""
    for size in sizes:
        if not isinstance(size, float | int):
            raise SdlError(f"the size of an array is a number, not {kind_of(size)}")
    return Array(tuple(map(int, sizes)), mixed=mixed)


def filled_array(sizes: tuple[Any, ...], mixed: bool, optional: bool, elements: list[Any]) -> Array:
    """``array[n][m] { {...}, ... }``; without sizes, as large as its elements."""
    new = array(sizes or _sizes(elements), mixed)
    new.fill(elements, optional)
    return new


def _sizes(elements: list[Any]) -> tuple[float, ...]:
    first = elements[0] if elements else None
    return (float(len(elements)), *(_sizes(first) if isinstance(first, list) else ()))


def array_elements(sink: Sink) -> list[Any]:
    """The elements in an array's braces, where directives supply some."""
    return calls.values_in_call((sink.items, sink.places), sink.place)


def unended(value: Any, version: float) -> Any:
    """The value of a declaration that no semicolon ends: from ``#version`` 3.5 on, numbers and strings need one."""
    if isinstance(value, float | Vector) and version >= 3.5:
        raise SdlError(
            "expected ';' after this declaration", hint="declarations of numbers, vectors and colours end with ';'"
        )
    return value


def library(running: Running) -> dict[str, Any]:
    """The table for one run."""
    blocks = running.blocks
    texts = FunctionTexts(running)
    writing: list[Symbol] = []

    def push_all(operand: Any, place: Place) -> None:
        for item in splice.items_of(operand):
            blocks.sink.push(item, place)

    def begin_declaration(take: Any, place: Place, count: int) -> None:
        blocks.sink = (
            pending.TupleSink(blocks, take, place, count) if count else pending.DeclarationSink(blocks, take, place)
        )

    def write_gathered(symbol: Symbol, sink: Sink, binary: str | None) -> None:
        for item in splice.joined(sink.items):
            running.write_file(symbol, item, binary)

    def begin_write(symbol: Symbol, place: Place) -> None:
        blocks.collect("write", place)
        writing.append(symbol)

    def end_write() -> None:
        sink = blocks.sink
        if sink.name != "write":
            raise SdlError("there is no open '(' for this ')'")
        blocks.collected(sink)
        symbol = writing.pop()
        binary: str | None = None
        for item in sink.items:
            if isinstance(item, Word | Punctuation):
                binary = item.name if isinstance(item, Word) else None
            else:
                running.write_file(symbol, item, binary)

    def define_macro(symbol: Symbol, parameters: tuple[str, ...], *compiled: Any) -> None:
        if symbol.declared and not isinstance(symbol.c.v, Macro):
            raise SdlError(f"'{symbol.name}' is declared already", hint=f"it is {kind_of(symbol.c.v)}; #undef it first")
        symbols = tuple(running.names[parameter] for parameter in parameters)
        symbol.c = FixedCell(symbol.name, Macro(symbol.name, parameters, symbols, blocks, *compiled))

    def run_statements(*what: Any) -> None:
        from minipov.interpreter.runtime.alike import Alike  # few scenes need it

        Alike(blocks, running.context.messages).run(*what)

    def push(item: Item, place: Place) -> None:
        blocks.sink.push(item, place)

    def extend(items: tuple[Item, ...], places: tuple[Place, ...]) -> None:
        blocks.sink.extend(items, places)

    names = dict(_PLAIN)
    names.update((f"f_{b.name}", partial(b.call, running) if b.runtime else b.call) for b in BUILTINS.values())
    names.update(
        (f.__name__, f) for f in (is_case, in_range, loop_step, loop_goes_on, array, filled_array, array_elements)
    )
    names.update(
        (f.__name__, f)
        for f in (push, extend, push_all, begin_declaration, write_gathered, define_macro, begin_write, end_write)
    )
    names.update((name, getattr(running, name)) for name in _OF_RUNNING)
    names |= {
        "open_block": blocks.open,
        "run_statements": run_statements,
        "function_of_text": texts.function_of_text,
        "expand_macro": texts.expand_macro,
        "include_function_text": texts.include_function_text,
        "close_block": blocks.close,
        "open_brace": blocks.open_brace,
        "open_bracket": blocks.open_bracket,
        "close_bracket": blocks.close_bracket,
        "collect": blocks.collect,
        "collected": blocks.collected,
        "settle": partial(pending.settle, blocks),
        "unended": lambda value, place: unended(value, running.context.version),
    }
    return names


_OF_RUNNING = (
    "include", "print_debug", "print_warning", "print_error", "obsolete", "obsolete_setting", "set_version", "variable",
    "characters", "open_file", "close_file", "read_file", "check_kind", "end_read", "write_file",
)  # fmt: skip
