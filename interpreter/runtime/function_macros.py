"""SDL: ``#macro Wave(F) sin(x*F) #end  #declare G = function { Wave(3) + y };``: macros inside functions.

A macro's body is text of the function that it stands in: there, ``x`` is the function's parameter. So it is parsed
anew, as the body of a function with the same parameters, each time it is called in one.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from minipov.grammar.errors import SdlSyntaxError
from minipov.interpreter.errors import Place, SdlError
from minipov.interpreter.runtime.macros import Macro
from minipov.interpreter.runtime.places import MARK
from minipov.interpreter.runtime.program import Running
from minipov.tracer.function import Expression, ExpressionFunction


def macro_in_function(
    running: Running, macro: Macro, cells: list[Any], parameters: Sequence[str] | None, place: Place
) -> Expression:
    """What a macro's body means in a function of these parameters; None stands for x, y, z.

    Raises:
        SdlError: the body is no expression of a function.
    """
    given = macro.filled(cells)
    before = [symbol.c for symbol in macro.symbols]
    for symbol, cell in zip(macro.symbols, given, strict=True):
        symbol.c = cell
    try:
        return _expression(running, macro, parameters)
    except SdlSyntaxError as error:
        raise SdlError(f"macro '{macro.name}' in a function: {error.message}", place, error.hint) from None
    finally:
        for symbol, cell in zip(macro.symbols, before, strict=True):
            symbol.c = cell


def _expression(running: Running, macro: Macro, parameters: Sequence[str] | None) -> Expression:
    from minipov.grammar.parser import parse
    from minipov.interpreter.compiler.files import compile_file

    file = macro.function.__globals__[MARK]
    start, end = macro.span
    source = running.sources[file]
    header = "function {" if parameters is None else f"function ({', '.join(parameters)}) {{"
    lines = "\n" * (source.count("\n", 0, start) - 1)
    program = compile_file(parse(f"{lines}{header}\n{source[start:end]}\n}}", file))
    sink = running.blocks.collect("function", (file, 1, 1))
    running.bound(file, program)()
    running.blocks.collected(sink)
    (function,) = sink.items
    assert isinstance(function, ExpressionFunction)
    return function.body
