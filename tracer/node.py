"""Nodes of the scene graph: dataclasses that nobody can change, yet quick to make.

>>> @node
... class Sphere:
...     center: Vec3
...     radius: float

A scene may hold millions of nodes, each made from another with a field or two replaced. A frozen dataclass fills its
fields through ``object.__setattr__``, one slow call for each. A node is filled as a *draft* instead: an object of a
class with the same slots that may be assigned to, which then turns into the node.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import MISSING, dataclass, fields
from typing import Any, Final, TypeVar, dataclass_transform, overload

T = TypeVar("T")

_KEPT: Final = object()
"""Stands for a field that `replace` was not told about."""


@overload
def node(cls: type[T]) -> type[T]: ...
@overload
def node(*, eq: bool) -> Callable[[type[T]], type[T]]: ...
@dataclass_transform(frozen_default=True)
def node(cls: type[T] | None = None, *, eq: bool = True) -> type[T] | Callable[[type[T]], type[T]]:
    """Make a class a node. With ``eq=False`` nodes are equal only to themselves, as suits those that hold arrays."""
    return _made(cls, eq=eq) if cls is not None else lambda given: _made(given, eq=eq)


def replace(node: T, /, **changes: Any) -> T:
    """The same node with other values in some fields."""
    old: Any = node
    new: T = old.__replace__(**changes)
    return new


def _made(cls: type[T], *, eq: bool) -> type[T]:
    made: Any = dataclass(frozen=True, slots=True, init=False, eq=eq)(cls)
    open_again = {"__slots__": made.__slots__, "__setattr__": object.__setattr__}
    draft = type(f"{cls.__name__}Draft", made.__bases__, open_again)
    methods = _methods(made, draft)
    made.__new__ = staticmethod(methods["__new__"])
    made.__replace__ = methods["__replace__"]
    made.__reduce__ = methods["__reduce__"]
    return made  # type: ignore[no-any-return]  # the same class, with slots


def _methods(made: Any, draft: type) -> dict[str, Any]:
    """The methods that name each field, so that no loop runs when a node is made."""
    known = {field.name: field.default for field in fields(made)}
    names = list(known)
    defaults = {f"default_{name}": value for name, value in known.items() if value is not MISSING}
    given = [f"{name}=default_{name}" if f"default_{name}" in defaults else name for name in names]
    lines = [
        f"def __new__({', '.join(['cls', *given])}):",
        "    self = new(draft)",
        *(f"    self.{name} = {name}" for name in names),
        "    self.__class__ = cls",
        "    return self",
        f"def __replace__({', '.join(['self', *(f'{name}=kept' for name in names)])}):",
        "    other = new(draft)",
        *(f"    other.{name} = self.{name} if {name} is kept else {name}" for name in names),
        "    other.__class__ = self.__class__",
        "    return other",
        "def __reduce__(self):",
        f"    return self.__class__, ({''.join(f'self.{name}, ' for name in names)})",
    ]
    namespace = {"new": object.__new__, "draft": draft, "kept": _KEPT, **defaults}
    exec("\n".join(lines), namespace)
    return namespace
