"""SDL: calls of what only the running program knows: macros whose arguments other macros give, functions, splines."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from difflib import get_close_matches
from typing import Any, NoReturn

import numpy as np
from minipov.interpreter.arrays import Array, Dictionary, subscript
from minipov.interpreter.errors import Place, SdlError
from minipov.interpreter.items import COMMA, Item, Sink, Word, complete
from minipov.interpreter.runtime.builtins import BUILTINS
from minipov.interpreter.runtime.evaluate import call_function, called_before
from minipov.interpreter.runtime.macros import MISSING, Gathered, Macro
from minipov.interpreter.runtime.names import Cell, ElementCell, Symbol
from minipov.interpreter.runtime.rvalues import rvalue
from minipov.interpreter.runtime.splice import Spliced, items_of, joined
from minipov.interpreter.values import COMPONENTS, Vector, kind_of, stored

_new = tuple.__new__


def fail(message: str, hint: str | None = None) -> NoReturn:
    """Stop with an error at this place."""
    raise SdlError(message, hint=hint)


def call(callee: Any, *values: Any) -> Any:
    """A call of what is no macro of that many arguments; one argument may turn out to be several."""
    known = called_before(callee, len(values))
    if known is not None:
        try:
            value = known(*values)
        except TypeError:
            pass  # not all are numbers: see below
        else:
            return Vector(value) if value.__class__ is tuple else value
    if any(value.__class__ is Spliced for value in values):
        values = tuple(_single_values([item for value in values for item in items_of(value)]))
        if isinstance(callee, Macro) and callee.arity == len(values):
            return callee.value(*map(Cell, values))
    if isinstance(callee, Macro):
        return callee.value(*callee.filled([Cell(value) for value in values]))
    return call_function(callee, values)


def element(container: Any, indices: tuple[Any, ...]) -> Any:
    """An element, to pass by reference."""
    if not isinstance(container, Array | Dictionary):
        subscript(container, *indices)
    return ElementCell(container, indices)


def member(of: Any, name: str) -> Any:
    """``D.name``, where the name is no vector component."""
    if isinstance(of, Dictionary):
        return of.get_item(name)
    close = get_close_matches(name, [*COMPONENTS, "gray"], 1)
    hint = f"did you mean '{close[0]}'?" if close else "components are x y z t u v red green blue filter transmit gray"
    raise SdlError(f"{kind_of(of)} has no component '{name}'", hint=hint)


def holds(symbol: Symbol, indices: tuple[Any, ...]) -> bool:
    """Whether an element of an array or dictionary has a value."""
    container = symbol.c.v if symbol.declared else None
    return isinstance(container, Array | Dictionary) and container.holds(*indices)


def _single_values(items: Sequence[Item]) -> list[Any]:
    values: list[Any] = []
    for item in items:
        if isinstance(item, np.ndarray):  # a long run of literal vectors
            values += map(Vector, item.tolist())
        elif item is not COMMA:
            values.append(item)
    return values


def call_gathered(callee: Any, way: str, sink: Sink, place: Place) -> Any:
    """A call whose argument list holds directives: each item is an argument."""
    return call_with([Cell(value) for value in _single_values(joined(sink.items))], callee, way)


def call_spread(callee: Any, way: str, *rest: Any) -> Any:
    """A call among whose arguments a macro may have given several."""
    cells: list[Any] = []
    for cell in rest[-1]:
        items = items_of(cell.v)
        cells += [cell] if len(items) == 1 and items[0] is cell.v else map(Cell, _single_values(items))
    return call_with(cells, callee, way)


def call_with(cells: list[Any], callee: Any, way: str) -> Any:
    """A call with these cells; empty places between the commas hold MISSING."""
    if isinstance(callee, Macro):
        return getattr(callee, way)(*callee.filled(cells))
    if MISSING in cells:
        fail("an argument is missing between the commas")
    return call(callee, *(cell.v for cell in cells))


def builtin_spread(name: str, function: Callable[..., Any], values: tuple[Any, ...]) -> Any:
    """A function of the language, among whose arguments a macro may have given several."""
    arguments = _single_values(joined(values))
    builtin = BUILTINS[name]
    if not builtin.least <= len(arguments) <= builtin.most:
        fail(f"{name}() takes {builtin.least} arguments, found {len(arguments)}")
    return function(*arguments)


def builtin_gathered(name: str, function: Callable[..., Any], sink: Sink) -> Any:
    """A function of the language whose argument list holds directives."""
    return builtin_spread(name, function, tuple(sink.items))


def rvalue_of(value: Any, what: str, place: Place) -> Any:
    """The one value of a call: what a function gave, or a macro's `single`."""
    if value.__class__ is Gathered:
        items, places = value.items, value.places
    elif value.__class__ is Spliced:
        items = value.items()
        places = [place] * len(items)
    else:
        return stored(complete(value))
    if COMMA in items and what == "argument":
        return Spliced(items)
    return rvalue(items, places, what, place)


def rvalue_in(sink: Sink, place: Place) -> Any:
    """The one value among the items of a sink."""
    return rvalue(sink.items, sink.places, sink.name, place)


def values_in_call(called: tuple[list[Item], list[Place]], place: Place) -> list[Any]:
    """The elements that a macro call gave, commas between them or not."""
    items, places = called
    if any(isinstance(item, Word) for item in items):
        return [rvalue(items, places, "array element", place)]
    return _single_values(items)


def vector(*terms: Any) -> Vector:
    """``<a, b, c>``."""
    if len(terms) < 2:
        fail("a vector has at least two terms")
    for term in terms:
        if term.__class__ is not float and not isinstance(term, float | int):
            fail(f"the terms of a vector are numbers, not {kind_of(term)}")
    return Vector(terms)


def vector3(a: Any, b: Any, c: Any) -> Vector:
    """``<a, b, c>``, the commonest."""
    if a.__class__ is b.__class__ is c.__class__ is float:
        return _new(Vector, (a, b, c))
    return vector(a, b, c)


def separated_vector(*terms: Any) -> Vector:
    """``<a, M(), c>`` with all commas: few macros give more than one term."""
    for term in terms:
        if term.__class__ is not float:
            return spliced_vector(tuple(part for term in terms for part in (term, COMMA)))
    return _new(Vector, terms) if 1 < len(terms) < 6 else vector(*terms)


def spliced_vector(terms: tuple[Any, ...]) -> Vector:
    """``<a M(), c>`` where macros may give several terms."""
    return vector(*_single_values(joined(terms)))


def gathered_vector(sink: Sink) -> Vector:
    """``< ... >`` with directives among the terms."""
    return vector(*_single_values(Spliced(sink.items).items()))


def gathered_value(sink: Sink) -> Any:
    """``( ... )`` with directives among the terms."""
    items = Spliced(sink.items).items()
    if len(items) != 1:
        raise SdlError(f"expected one value in these parentheses, found {len(items) or 'none'}")
    return items[0]
