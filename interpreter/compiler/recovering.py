"""A scene's own file, compiled so that after a mistake it goes on with the next statement, to find the others."""

from __future__ import annotations

from collections.abc import Sequence

from minipov.grammar import tree
from minipov.interpreter.compiler.body import Unit
from minipov.interpreter.compiler.declarations import local_names
from minipov.interpreter.compiler.files import FileBody, finished
from minipov.interpreter.compiler.items import Run
from minipov.interpreter.compiler.program import Program


class RecoveringBody(FileBody):
    """The items of a file, each in a ``try`` of its own."""

    _within = False

    def items(self, items: Sequence[tree.Item]) -> None:
        """As `Items.items`."""
        if self._within:
            super().items(items)
            return
        self._within = True
        at = 0
        while at < len(items):
            item, run = items[at], Run()
            with self.block() as made:
                at = self.one(items, at, run)
                self.flush(run)
            declared = item.targets[0] if isinstance(item, tree.Declare) else None
            name = declared.name if isinstance(declared, tree.Name) else None
            self.emit.at(item)
            recovered = self.emit.call("recovered", self.emit.name("problem"), self.emit.constant(name))
            self.add(self.emit.try_(made, "problem", [self.emit.do(recovered)]))


def compile_recovering(file: tree.File, *, utf8: bool) -> Program:
    """The code of a scene's own file.

    Raises:
        SdlError: the file is nested too deeply for Python's compiler.
    """
    return finished(RecoveringBody(Unit(file.path, utf8=utf8), (), local_names(file.items)), file)
