"""What can be wrong with a scene, and where.

A place is a plain tuple (file, line, column), 1-based, so that compiled code can hold it as a constant.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Literal, TypeAlias

Place: TypeAlias = tuple[str, int, int]
"""File, line, column; both counted from 1."""

NOWHERE: Place = ("", 0, 0)


@dataclass(slots=True, eq=False)
class SdlError(Exception):
    """A mistake in the scene that ends the run.

    ``hint`` says what would fix it or what was probably meant; ``stack`` lists the open macro calls and includes, the
    innermost first, as (what, place of the call).
    """

    message: str
    place: Place = NOWHERE
    hint: str | None = None
    stack: tuple[tuple[str, Place], ...] = ()

    def __str__(self) -> str:
        return f"{where(self.place)}error: {self.message}"


class NotDeclaredError(SdlError):
    """A name is used that stands for nothing."""

    def __init__(self, name: str, hint: str | None = None) -> None:
        super().__init__(f"'{name}' is not declared", hint=hint)
        self.name = name


class HaltedError(SdlError):
    """The scene itself ends the run."""


def where(place: Place) -> str:
    """A place as the start of a message line; empty if it is not known."""
    file, line, column = place
    return f"{file}:{line}:{column}: " if line else f"{file}: " if file else ""


def format_error(error: SdlError, sources: Mapping[str, str], severity: str = "error") -> str:
    """The error as people read it: place, message, source line with a caret, hint, open macros and includes.

    ``sources`` maps file names, as they stand in places, to their text; what is missing is left out. ``severity``
    stands before the message.
    """
    lines = [f"{where(error.place)}{severity}: {error.message}"]
    file, line, column = error.place
    text = sources.get(file, "").split("\n")
    if 0 < line <= len(text):
        source = text[line - 1]
        before = "".join("\t" if character == "\t" else " " for character in source[: column - 1])
        lines += [f"  {source}", f"  {before}^"]
    if error.hint is not None:
        lines.append(f"  hint: {error.hint}")
    lines += [f"  {where(place)}{what}" for what, place in error.stack]
    return "\n".join(lines)


@dataclass(frozen=True, slots=True)
class Message:
    """One line for the user that does not end the run."""

    kind: Literal["warning", "debug", "note"]
    text: str
    place: Place = NOWHERE


@dataclass(slots=True)
class Messages:
    """Where warnings and ``#debug`` text go; ``sink`` is called as they come."""

    sink: Callable[[Message], None] | None = None
    all: list[Message] = field(default_factory=list)
    moved: Callable[[Place], Place] | None = None
    """Where a place really is, while statements alike share their code."""
    _said: set[str] = field(default_factory=set)

    def say(self, message: Message) -> None:
        """Pass a message on."""
        self.all.append(message)
        if self.sink is not None:
            self.sink(message)

    @contextmanager
    def aside(self) -> Iterator[Messages]:
        """Messages said inside go to a copy of their own, which is given."""
        aside = Messages(_said=self._said.copy())
        kept = self.sink, self.all, self._said
        self.sink, self.all, self._said = None, aside.all, aside._said
        try:
            yield aside
        finally:
            self.sink, self.all, self._said = kept

    def warn(self, text: str, place: Place = NOWHERE) -> None:
        """Warn each time."""
        self.say(Message("warning", text, place if self.moved is None else self.moved(place)))

    def warn_once(self, key: str, text: str, place: Place = NOWHERE) -> None:
        """Warn the first time that ``key`` comes up."""
        if key not in self._said:
            self._said.add(key)
            self.warn(text, place)
