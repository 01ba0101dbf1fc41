"""The nodes of ``#declare``, ``#if``, ``#macro`` and the other directives; `tree` has all the rest."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, TypeAlias

from minipov.grammar.node import Node

if TYPE_CHECKING:
    from minipov.grammar.tree import Block, Expression, Item


@dataclass(frozen=True, slots=True)
class Declare(Node):
    """``#declare target =`` or ``#local``; the items that follow supply the value.

    ``targets`` has several for the tuples of 3.8, written ``( )``, ``< >`` or ``{ }`` as ``form`` says.
    """

    local: bool
    targets: tuple[Expression | None, ...]
    form: Literal["", "(", "<", "{"] = ""
    deprecated: bool = False
    deprecated_once: bool = False
    deprecated_text: Expression | None = None
    optional: tuple[bool, ...] = ()
    bare: bool = False
    """Whether the ``#`` is missing, as in scenes of long ago."""


@dataclass(frozen=True, slots=True)
class Undef(Node):
    """``#undef target``."""

    target: Expression


@dataclass(frozen=True, slots=True)
class Include(Node):
    """``#include string``."""

    file: Expression


@dataclass(frozen=True, slots=True)
class Branch(Node):
    """A condition with what it guards; ``defined`` True is ``#ifdef``, False ``#ifndef``, None a plain condition."""

    condition: Expression
    items: tuple[Item, ...]
    defined: bool | None = None


@dataclass(frozen=True, slots=True)
class If(Node):
    """``#if`` / ``#ifdef`` / ``#ifndef`` with ``#elseif`` and ``#else``."""

    branches: tuple[Branch, ...]
    otherwise: tuple[Item, ...] | None


@dataclass(frozen=True, slots=True)
class Case(Node):
    """``#case (F)`` (``high`` None), ``#range (low, high)``, or ``#else`` (both None)."""

    low: Expression | None
    high: Expression | None
    items: tuple[Item, ...]


@dataclass(frozen=True, slots=True)
class Switch(Node):
    """``#switch (F)`` with its cases; control falls from one into the next."""

    value: Expression
    cases: tuple[Case, ...]


@dataclass(frozen=True, slots=True)
class While(Node):
    """``#while (F) ... #end``."""

    condition: Expression
    items: tuple[Item, ...]


@dataclass(frozen=True, slots=True)
class For(Node):
    """``#for (name, start, end, step) ... #end``; ``step`` None means 1."""

    name: str
    start: Expression
    end: Expression
    step: Expression | None
    items: tuple[Item, ...]


@dataclass(frozen=True, slots=True)
class Break(Node):
    """``#break``."""


@dataclass(frozen=True, slots=True)
class Macro(Node):
    """``#macro name (parameters) ... #end``."""

    name: str
    parameters: tuple[str, ...]
    optional: tuple[bool, ...]
    items: tuple[Item, ...]
    span: tuple[int, int] = (0, 0)
    """Where in the text the items begin and end."""


@dataclass(frozen=True, slots=True)
class Default(Node):
    """``#default { ... }``."""

    block: Block


@dataclass(frozen=True, slots=True)
class Version(Node):
    """``#version F;``."""

    value: Expression
    unofficial: bool = False


@dataclass(frozen=True, slots=True)
class Print(Node):
    """``#debug``, ``#warning``, ``#error``, and the obsolete ``#render`` and ``#statistics``."""

    stream: Literal["debug", "warning", "error", "render", "statistics"]
    text: Expression


@dataclass(frozen=True, slots=True)
class FileOpen(Node):
    """``#fopen name file mode``."""

    name: str
    file: Expression
    mode: Literal["read", "write", "append"]


@dataclass(frozen=True, slots=True)
class FileClose(Node):
    """``#fclose name``."""

    name: str


@dataclass(frozen=True, slots=True)
class FileRead(Node):
    """``#read (name, target, ...)``."""

    name: str
    targets: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class FileWrite(Node):
    """``#write (name, item, ...)``; words such as ``uint8`` are `Keyword` items."""

    name: str
    items: tuple[Item, ...]


@dataclass(frozen=True, slots=True)
class FileWriteOpen(Node):
    """``#write (name,`` whose parenthesis closes outside the directive body that it stands in.

    What comes up to the `LooseParen` is written.
    """

    name: str


@dataclass(frozen=True, slots=True)
class Obsolete(Node):
    """``#max_trace_level F`` and ``#max_intersections F``."""

    name: str
    value: Expression


Directive: TypeAlias = (
    Declare
    | Undef
    | Include
    | If
    | Switch
    | While
    | For
    | Break
    | Macro
    | Default
    | Version
    | Print
    | FileOpen
    | FileClose
    | FileRead
    | FileWrite
    | FileWriteOpen
    | Obsolete
)
