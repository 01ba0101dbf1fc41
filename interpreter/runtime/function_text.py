"""SDL: ``function { 0 #for (I, 1, 3) + I*x #end  2*M() }``: bodies of functions that only what runs can read.

In a function a macro's body and an include file are tokens of the function, as text is: there, ``x`` is a parameter. So
they are parsed anew for it. The row of tokens that results is read by `function_parser`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from minipov.grammar.errors import SdlSyntaxError
from minipov.grammar.text import decode
from minipov.interpreter.errors import Place, SdlError
from minipov.interpreter.functions import DEFAULT_PARAMETERS, parameter_numbers
from minipov.interpreter.items import Named
from minipov.interpreter.runtime.macros import Macro
from minipov.interpreter.runtime.names import Symbol
from minipov.interpreter.runtime.places import MARK
from minipov.interpreter.runtime.program import Running
from minipov.tracer.function import ExpressionFunction


def any_macro(*symbols: Symbol) -> bool:
    """Whether one of these names is a macro now."""
    return any(symbol.declared and isinstance(symbol.c.v, Macro) for symbol in symbols)


def named(symbol: Symbol) -> Named:
    """A name among the tokens."""
    return Named(symbol.name, symbol.c.v if symbol.declared else None)


class FunctionTexts:
    """Reads bodies of functions for one run."""

    def __init__(self, running: Running) -> None:
        self._running = running
        self._macros: dict[int, tuple[Macro, Callable[[], None]]] = {}

    def function_of_text(self, parameters: Sequence[str] | None, text: str, place: Place) -> ExpressionFunction:
        """The function whose body is ``text``; ``parameters`` None stands for x, y, z."""
        from minipov.interpreter.runtime.function_parser import FunctionParser

        run = self._compiled(text, place)
        sink = self._running.blocks.collect("function", place)
        run()
        self._running.blocks.collected(sink)
        scope = parameter_numbers(parameters)
        parser = FunctionParser(sink.items, sink.places, scope, self._running.variable)
        return ExpressionFunction(tuple(parameters or DEFAULT_PARAMETERS), parser.whole())

    def expand_macro(self, macro: Any, cells: list[Any], place: Place) -> None:
        """A macro called in a body: its own body's tokens."""
        if not isinstance(macro, Macro):
            raise SdlError("this is no macro any more", place)
        known = self._macros.get(id(macro))
        if known is None:
            known = self._macros[id(macro)] = (macro, self._body(macro))
        given = macro.filled(cells)
        before = [symbol.c for symbol in macro.symbols]
        for symbol, cell in zip(macro.symbols, given, strict=True):
            symbol.c = cell
        try:
            known[1]()
        finally:
            for symbol, cell in zip(macro.symbols, before, strict=True):
                symbol.c = cell

    def include_function_text(self, file: Any, place: Place) -> None:
        """``#include`` in a body: the file's tokens."""
        path, content = self._running.included(file, place)
        self._compiled(decode(content), (str(path), 1, 1))()

    def _body(self, macro: Macro) -> Callable[[], None]:
        file = macro.function.__globals__[MARK]
        start, end = macro.span
        source = self._running.sources[file]
        column = start - source.rfind("\n", 0, start)
        return self._compiled(source[start:end], (file, source.count("\n", 0, start) + 1, column))

    def _compiled(self, text: str, place: Place) -> Callable[[], None]:
        from minipov.grammar.parser import parse_function
        from minipov.interpreter.compiler.function_texts import compile_function_text

        file, line, column = place
        names = self._running.names
        try:
            items = parse_function(text, file, line, column, lambda name: name in names and any_macro(names[name]))
        except SdlSyntaxError as error:
            raise SdlError(error.message, (file, error.line, error.column), error.hint) from None
        return self._running.bound(file, compile_function_text(items))
