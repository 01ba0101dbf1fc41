"""SDL: ``function { 0 #for (I, 1, 3) + I*x #end  2*M() }``: the tokens of a function's body, directives among them.

What is left when this code has run is a row of tokens, which `runtime.function_text` reads as an expression.
"""

from __future__ import annotations

import ast

from minipov.grammar import tree
from minipov.interpreter.compiler.body import Unit
from minipov.interpreter.compiler.declarations import local_names
from minipov.interpreter.compiler.files import FileBody, finished
from minipov.interpreter.compiler.program import Program
from minipov.interpreter.compiler.shapes import argument_groups
from minipov.interpreter.errors import SdlError


class FunctionTextBody(FileBody):
    """The tokens and directives of a function's body, or of a macro or file that stands in one."""

    def function_name(self, node: tree.FunctionName) -> ast.expr:
        """A name and what it stands for now, if for anything."""
        return self.emit.at(node).call("named", self.symbol(node.name))

    def run_call(self, node: tree.Call) -> None:
        """A macro: its body's tokens."""
        groups = argument_groups(node.items)
        if groups is None or not all(groups):
            self.add(self.emit.do(self._failing(SdlError("expected values between commas"), node)))
            return
        first: list[ast.expr] = []
        cells = [self._argument(group, first, node)[0] for group in groups]
        for value in first:
            self.add(self.emit.at(node).do(value))
        callee = self.value(node.of)
        self.emit.at(node)
        self.do("expand_macro", callee, self.emit.list(cells), self.place(node))

    def _file_call(self, function: str, file: tree.Expression, node: tree.Node) -> None:
        super()._file_call(f"{function}_function_text", file, node)


def compile_function_text(file: tree.File) -> Program:
    """The code of a body's tokens.

    Raises:
        SdlError: the text is nested too deeply for Python's compiler.
    """
    return finished(FunctionTextBody(Unit(file.path), (), local_names(file.items)), file)
