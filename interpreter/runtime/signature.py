"""The table of SDL's own functions: what compiled code calls for ``sin(X)``."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeVar

F = TypeVar("F", bound=Callable[..., Any])


@dataclass(frozen=True, slots=True)
class BuiltIn:
    """A function of the language; ``runtime`` says that it takes the running program as its first argument."""

    name: str
    call: Callable[..., Any]
    least: int
    most: int
    runtime: bool

    @property
    def pure(self) -> bool:
        """Whether it gives the same for the same arguments, so that it may be computed once."""
        return not self.runtime


BUILTINS: dict[str, BuiltIn] = {}


def builtin(name: str, least: int, most: int | None = None, *, runtime: bool = False) -> Callable[[F], F]:
    """Enter a function into the table, with the least and most number of its arguments."""

    def register(function: F) -> F:
        BUILTINS[name] = BuiltIn(name, function, least, least if most is None else most, runtime)
        return function

    return register
