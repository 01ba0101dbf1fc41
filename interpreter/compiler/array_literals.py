"""SDL: ``array[2][3] { {1, 2, 3}, {4, 5, 6} }``, and 3.8's ``array mixed [2]``, ``dictionary { ["a"]: 1, .b: 2 }``."""

from __future__ import annotations

import ast
from collections.abc import Sequence

from minipov.grammar import tree
from minipov.interpreter.compiler.items import Items, Run
from minipov.interpreter.compiler.shapes import EXPRESSIONS, argument_groups


class ArrayLiterals(Items):
    """Compiles arrays."""

    def array(self, items: Sequence[tree.Item], at: int, run: Run) -> tuple[ast.expr, int]:
        """``array[n] { ... }``; gives its value and the index after it."""
        word = items[at]
        assert isinstance(word, tree.Keyword)
        at += 1
        mixed = optional = False
        sizes: list[ast.expr] = []
        while at < len(items):
            item = items[at]
            if isinstance(item, tree.Keyword) and item.name in ("mixed", "optional"):
                mixed = mixed or item.name == "mixed"
                optional = optional or item.name == "optional"
            elif isinstance(item, tree.Bracket) and len(item.items) == 1 and isinstance(item.items[0], EXPRESSIONS):
                sizes.append(self.value(item.items[0]))
            else:
                break
            at += 1
        block = items[at] if at < len(items) else None
        self.emit.at(word)
        if isinstance(block, tree.Block):
            content = self._elements(block)
            self.emit.at(word)
            flags = self.emit.constant(mixed), self.emit.constant(optional)
            return self.emit.call("filled_array", self.emit.tuple(sizes), *flags, content), at + 1
        return self.emit.call("array", self.emit.tuple(sizes), self.emit.constant(mixed)), at

    def _elements(self, block: tree.Block) -> ast.expr:
        """The elements in braces as nested lists; None stands for an element left out."""
        parts = _split(block.items)
        if parts is None:
            sink = self.gather(block.items, "array", block)
            return self.emit.at(block).call("array_elements", self.emit.name(sink))
        elements: list[ast.expr] = []
        for part in parts:
            if not part:
                elements.append(self.emit.at(block).constant(None))
            elif len(part) == 1 and isinstance(part[0], tree.Block):
                elements.append(self._elements(part[0]))
            elif len(part) == 1 and isinstance(part[0], tree.Call):
                several = self.emit.at(part[0]).call("values_in_call", self.items_call(part[0]), self.place(part[0]))
                elements.append(self.emit.starred(several))
            else:
                elements.append(self.rvalue(part, "array element"))
        return self.emit.at(block).list(elements)


def _split(items: Sequence[tree.Item]) -> list[Sequence[tree.Item]] | None:
    """The items of each element; None where directives may supply some."""
    parts: list[Sequence[tree.Item]] = []
    group: list[tree.Item] = []
    after_comma = True

    def end_group() -> bool:
        split = argument_groups(group)
        parts.extend(split or ())
        group.clear()
        return split is not None

    for item in items:
        if isinstance(item, tree.Punctuation) and item.text == ",":
            if not end_group():
                return None
            if after_comma:
                parts.append(())
            after_comma = True
            continue
        after_comma = False
        if isinstance(item, tree.Block) and not (group and isinstance(group[-1], tree.Keyword | tree.Bracket)):
            if not end_group():
                return None
            parts.append((item,))
        else:
            group.append(item)
    return parts if end_group() else None
