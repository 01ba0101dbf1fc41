"""Casting statements alike: what the first statement of a shape gave is a mould for the others.

The first statement is read with numbers that know their hole. Where such a number arrives unchanged in the scene node,
the other statements' numbers can be put in its place, without reading all items again. Anything a construct does with
such a number but pass it on is noticed: comparisons become conditions that the other statements must meet as well,
arithmetic makes the shape unfit. Some rows are read in both ways to be sure.
"""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable, Sequence
from dataclasses import fields, is_dataclass
from typing import Any, Final

import numpy as np
from minipov.interpreter.compiler.emit import Emitter
from minipov.interpreter.values import Vector
from numpy.typing import NDArray

_MOST_PROOFS: Final = 24


class Unfit(Exception):
    """A number of the mould was computed with."""


class Hole(float):
    """A number that remembers which hole of the shape it came from."""

    index: int
    conditions: list[tuple[Callable[[Any, Any], Any], Any, Any, bool]]

    def __new__(cls, value: float, index: int, conditions: list[Any]) -> Hole:
        self = super().__new__(cls, value)
        self.index = index
        self.conditions = conditions
        return self

    def __bool__(self) -> bool:
        return bool(self != 0.0)

    __hash__ = None  # type: ignore[assignment]  # a key of a table would be computed with too


def _unfit(*_: Any) -> Any:
    raise Unfit


def _compared(name: str) -> Callable[[Hole, Any], Any]:
    plain = getattr(operator, name)

    def compared(self: Hole, other: Any) -> Any:
        if not isinstance(other, float | int):
            return NotImplemented
        outcome = bool(plain(float.__float__(self), float.__float__(other) if isinstance(other, float) else other))
        self.conditions.append((plain, self, other, outcome))
        return outcome

    return compared


for _name in ("lt", "le", "eq", "ne", "gt", "ge"):
    setattr(Hole, f"__{_name}__", _compared(_name))
for _name in (
    "add", "radd", "sub", "rsub", "mul", "rmul", "truediv", "rtruediv", "floordiv", "rfloordiv", "mod", "rmod", "pow",
    "rpow", "neg", "pos", "abs", "int", "trunc", "floor", "ceil", "round", "divmod", "rdivmod", "format", "str", "repr",
):  # fmt: skip
    setattr(Hole, f"__{_name}__", _unfit)


class Mould:
    """Makes the node of a row of a shape that meets the ``conditions``: ``cast(numbers, line)``."""

    def __init__(self, node: Any, file: str, line: int, conditions: list[Any]) -> None:
        self._emit = Emitter()
        self._constants: dict[str, Any] = {"source": lambda line: f"{file}:{line}"}
        self._source = f"{file}:{line}"
        self._conditions = conditions
        made = self._code(node)
        if made is None:
            raise Unfit
        function = self._emit.function("cast", ("n", "line"), [self._emit.return_(made)], opens=False)
        exec(compile(ast.Module([function], []), "<mould>", "exec"), self._constants)
        self.cast: Callable[[Sequence[float], int], Any] = self._constants["cast"]

    def fitting(self, rows: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Which rows meet the conditions."""
        fits = np.ones(len(rows), dtype=bool)
        for test, left, right, outcome in self._conditions:
            fits &= np.asarray(test(_column(left, rows), _column(right, rows))) == outcome
        return fits

    def _code(self, value: Any) -> ast.expr | None:
        """Code that makes ``value`` for a row; None where it holds no hole, and may be shared."""
        if isinstance(value, Hole):
            return self._emit.item(self._emit.name("n"), value.index)
        if value.__class__ in (tuple, Vector):
            parts = self._parts(value)
            if parts is None:
                return None
            terms = self._emit.tuple(parts)
            return terms if value.__class__ is tuple else self._emit.call(self._constant(Vector), terms)
        if isinstance(value, str):
            return self._emit.call("source", self._emit.name("line")) if value == self._source else None
        if isinstance(value, np.ndarray | list | dict | set):
            raise Unfit
        if not is_dataclass(value):
            return None
        parts = self._parts([getattr(value, field.name) for field in fields(value) if field.init])
        return None if parts is None else self._emit.call(self._constant(type(value)), *parts)

    def _parts(self, values: Sequence[Any]) -> list[ast.expr] | None:
        codes = [self._code(value) for value in values]
        if not any(codes):
            return None
        return [code or self._constant(value) for code, value in zip(codes, values, strict=True)]

    def _constant(self, value: Any) -> ast.expr:
        name = f"c{len(self._constants)}"
        self._constants[name] = value
        return self._emit.name(name)


def _column(operand: Any, rows: NDArray[np.float64]) -> Any:
    return rows[:, operand.index] if isinstance(operand, Hole) else operand


def proofs(rows: NDArray[np.float64]) -> Sequence[int]:
    """Rows to read both ways: between them, every hole has another number than in the first row."""
    others = (int(np.argmax(rows[:, column] != rows[0, column])) for column in range(min(rows.shape[1], _MOST_PROOFS)))
    return sorted({*others, len(rows) - 1} - {0})
