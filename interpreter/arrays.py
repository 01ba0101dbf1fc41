"""SDL: ``array[3][2] { {1, 2}, {3, 4} }``; of 3.8 ``array mixed[2]``, ``array`` that grows, ``dictionary``."""

from __future__ import annotations

from typing import Any, NoReturn

from minipov.interpreter.errors import SdlError
from minipov.interpreter.values import COMPONENTS, Vector, kind_of

MOST_DIMENSIONS = 5
MOST_ELEMENTS = 100_000_000


class _Unset:
    def __repr__(self) -> str:
        return "UNSET"


UNSET = _Unset()
"""An element that nothing was assigned to yet."""


def same_kind(a: Any, b: Any) -> bool:
    """Whether two values may stand in one array: the same type, vectors of the same size."""
    if isinstance(a, Vector) and isinstance(b, Vector):
        return len(a) == len(b)
    if isinstance(a, Vector) or isinstance(b, Vector):
        return False
    return type(a) is type(b) or family(a) == family(b) != ""


def family(value: Any) -> str:
    """The package-level kind of a scene node: all textures are of one kind, all functions too."""
    name = type(value).__name__
    for kind in ("Texture", "Function"):
        if name.endswith(kind) or name in _FAMILIES.get(kind, ()):
            return kind
    return ""


_FAMILIES = {"Texture": ("MaterialMap",), "Function": ("FunctionValue",)}


class Array:
    """A rectangle of values of one kind (unless ``mixed``). Indices are cut to integers.

    ``sizes`` is empty for an array that grows on access.
    """

    __slots__ = ("elements", "grows", "kind", "mixed", "sizes", "strides")
    sdl_kind = "array"

    def __init__(self, sizes: tuple[int, ...], *, mixed: bool = False) -> None:
        if any(size < 1 for size in sizes):
            raise SdlError("an array needs at least one element in each dimension")
        if len(sizes) > MOST_DIMENSIONS:
            raise SdlError(f"an array has at most {MOST_DIMENSIONS} dimensions")
        self.grows = not sizes
        self.sizes = sizes or (0,)
        self.mixed = mixed
        self.kind: Any = UNSET
        strides = [1]
        for size in reversed(self.sizes[1:]):
            strides.insert(0, strides[0] * size)
        self.strides = tuple(strides)
        count = strides[0] * self.sizes[0]
        if count > MOST_ELEMENTS:
            raise SdlError(f"an array of {count} elements is too large")
        self.elements: list[Any] = [UNSET] * count

    def copy(self) -> Array:
        """An array of its own, arrays inside it copied too."""
        twin = object.__new__(Array)
        twin.sizes, twin.mixed, twin.kind, twin.strides, twin.grows = (
            self.sizes, self.mixed, self.kind, self.strides, self.grows,
        )  # fmt: skip
        twin.elements = [copied(e) for e in self.elements] if self._holds_containers() else self.elements.copy()
        return twin

    def _holds_containers(self) -> bool:
        return self.mixed or isinstance(self.kind, Array | Dictionary)

    def _at(self, indices: tuple[float, ...]) -> int:
        if len(indices) != len(self.sizes):
            self._wrong_count(indices)
        at = 0
        for index, size, stride in zip(indices, self.sizes, self.strides, strict=True):
            whole = int(index)
            if not 0 <= whole < size:
                if self.grows and whole >= 0:
                    self.elements.extend([UNSET] * (whole + 1 - size))
                    self.sizes = (whole + 1,)
                else:
                    raise SdlError(f"array subscript {whole} out of range", hint=f"valid are 0 to {size - 1}")
            at += whole * stride
        return at

    def _wrong_count(self, indices: tuple[float, ...]) -> NoReturn:
        raise SdlError(f"the array has {len(self.sizes)} dimensions, but {len(indices)} subscripts are given")

    def fetch(self, *indices: float) -> Any:
        """An element. More subscripts than dimensions go on into an array held as element.

        Raises:
            SdlError: out of range, too few subscripts, or nothing was assigned yet.
        """
        own = indices[: len(self.sizes)]
        inside = len(indices) == 1 == len(self.sizes) and 0 <= indices[0] < self.sizes[0]
        value = self.elements[int(indices[0]) if inside else self._at(own)]
        if value is UNSET:
            raise SdlError("this array element has no value yet", hint="test it with #ifdef, or assign it first")
        return subscript(value, *indices[len(own) :]) if len(indices) > len(own) else value

    def holds(self, *indices: float) -> bool:
        """Whether an element has a value."""
        own = indices[: len(self.sizes)]
        value = self.elements[self._at(own)]
        if len(indices) > len(own) and isinstance(value, Array | Dictionary):
            return value.holds(*indices[len(own) :])
        return value is not UNSET

    def assign(self, value: Any, *indices: float) -> None:
        """Assign an element; the first one fixes the kind of all."""
        own = indices[: len(self.sizes)]
        at = self._at(own)
        if len(indices) > len(own):
            inner = self.elements[at]
            if not isinstance(inner, Array | Dictionary):
                self._wrong_count(indices)
            inner.assign(value, *indices[len(own) :])
            return
        if not self.mixed:
            if self.kind is UNSET:
                self.kind = value
            elif not same_kind(self.kind, value):
                raise SdlError(f"the elements of this array are each {kind_of(self.kind)}, not {kind_of(value)}")
        self.elements[at] = value

    def fill(self, elements: list[Any], optional: bool, *indices: float) -> None:
        """Assign what an initialiser lists, one list for each dimension; None stands for an element left out."""
        own = self.sizes[len(indices)] if len(indices) < len(self.sizes) else 0
        if len(elements) > own:
            raise SdlError(f"too many elements for an array of {own}")
        if not optional and (len(elements) < own or None in elements):
            found = sum(element is not None for element in elements)
            raise SdlError(f"{own} elements are needed, found {found}", hint="'optional' before the braces allows gaps")
        for number, element in enumerate(elements):
            if isinstance(element, list):
                self.fill(element, optional, *indices, number)
            elif element is not None:
                self.assign(element, *indices, number)

    def erase(self, *indices: float) -> None:
        """``#undef`` of an element."""
        self.elements[self._at(indices)] = UNSET


class Dictionary(dict[str, Any]):
    """3.8: ``dictionary { ["key"]: value, .name: value }``."""

    sdl_kind = "dictionary"

    def copy(self) -> Dictionary:
        """A dictionary of its own, containers inside it copied too."""
        return Dictionary((key, copied(value)) for key, value in self.items())

    def __getattr__(self, name: str) -> Any:
        """The value of a key that is also the name of a component: ``D.x``."""
        if name not in COMPONENTS:
            raise AttributeError(name)
        return self.get_item(name)

    def get_item(self, key: Any) -> Any:
        """The value of a key."""
        if not isinstance(key, str):
            raise SdlError(f"a dictionary key is a string, not {kind_of(key)}")
        if key not in self:
            raise SdlError(f"the dictionary has no entry '{key}'")
        return self[key]

    def fetch(self, key: Any, *more: Any) -> Any:
        """The value of a key, or of further subscripts within it."""
        value = self.get_item(key)
        return subscript(value, *more) if more else value

    def holds(self, key: Any, *more: Any) -> bool:
        """Whether there is such an entry."""
        if not more or key not in self:
            return key in self
        value = self[key]
        return isinstance(value, Array | Dictionary) and value.holds(*more)

    def assign(self, value: Any, key: Any, *more: Any) -> None:
        """Assign an entry."""
        if more:
            self.get_item(key).assign(value, *more)
        elif not isinstance(key, str):
            raise SdlError(f"a dictionary key is a string, not {kind_of(key)}")
        else:
            self[key] = value

    def erase(self, key: Any) -> None:
        """``#undef`` of an entry."""
        self.pop(key, None)


def subscript(container: Any, *indices: Any) -> Any:
    """``A[i][j]`` or ``D["key"]``."""
    if isinstance(container, Array):
        return container.fetch(*indices)
    if isinstance(container, Dictionary):
        return container.fetch(*indices)
    raise SdlError(f"{kind_of(container)} has no elements", hint="subscripts need an array")


def copied(value: Any) -> Any:
    """What ``#declare B = A;`` stores: containers are copied, everything else never changes."""
    return value.copy() if isinstance(value, Array | Dictionary) else value
