"""The nodes of a parsed file. Every node knows the line and column (from 1) where it begins.

A file is a sequence of items; braces, brackets, vectors and argument lists hold items too, because directives and macro
calls may supply any part of them. Which items a block accepts is not the grammar's business.

The value of ``#declare X = ...`` is not part of the `Declare` node: it is the items that follow it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal, TypeAlias

import numpy as np
from minipov.grammar.directive_nodes import (
    Branch as Branch,
    Break as Break,
    Case as Case,
    Declare as Declare,
    Default as Default,
    Directive as Directive,
    FileClose as FileClose,
    FileOpen as FileOpen,
    FileRead as FileRead,
    FileWrite as FileWrite,
    FileWriteOpen as FileWriteOpen,
    For as For,
    If as If,
    Include as Include,
    Macro as Macro,
    Obsolete as Obsolete,
    Print as Print,
    Switch as Switch,
    Undef as Undef,
    Version as Version,
    While as While,
)
from minipov.grammar.errors import SdlSyntaxError
from minipov.grammar.node import Node as Node
from numpy.typing import NDArray

# --- expressions ---


@dataclass(frozen=True, slots=True)
class Number(Node):
    """A float literal, without sign."""

    value: float


@dataclass(frozen=True, slots=True)
class Hole(Node):
    """A number that differs from row to row of `Statements`."""

    index: int


@dataclass(frozen=True, slots=True)
class String(Node):
    """A string literal as written between the quotes; `lexer.unescape` gives its text."""

    raw: str


@dataclass(frozen=True, slots=True)
class Name(Node):
    """An identifier."""

    name: str


@dataclass(frozen=True, slots=True)
class Scoped(Node):
    """3.8: ``local.name``, ``global.name``: a name looked up in one table only."""

    scope: Literal["local", "global"]
    name: str


@dataclass(frozen=True, slots=True)
class ConstantWord(Node):
    """A keyword that is a value: ``x``, ``pi``, ``clock``, ``on``, ``image_width``..."""

    name: str


@dataclass(frozen=True, slots=True)
class Vector(Node):
    """``< ... >``."""

    items: tuple[Item, ...]


@dataclass(frozen=True, slots=True)
class Unary(Node):
    """``-a``, ``+a``, ``!a``."""

    operator: Literal["-", "+", "!"]
    operand: Expression


@dataclass(frozen=True, slots=True)
class Binary(Node):
    """``a + b`` and all other operators of two operands; begins where ``a`` begins."""

    operator: str
    left: Expression
    right: Expression


@dataclass(frozen=True, slots=True)
class Conditional(Node):
    """``(condition ? yes : no)``."""

    condition: Expression
    yes: Expression
    no: Expression


@dataclass(frozen=True, slots=True)
class Paren(Node):
    """``( ... )``, kept because it stops a macro's open terms from being taken apart."""

    inner: Expression


@dataclass(frozen=True, slots=True)
class Group(Node):
    """``( ... )`` with directives or commas inside: ``(#if (A) 1 #else 2 #end)``; worth what its items leave."""

    items: tuple[Item, ...]


@dataclass(frozen=True, slots=True)
class Member(Node):
    """``a.x``, ``c.red``, 3.8 ``d.key``."""

    of: Expression
    name: str
    end_line: int = 0
    end_column: int = 0
    """Where the name begins."""


@dataclass(frozen=True, slots=True)
class Subscript(Node):
    """``a[i]``; several dimensions nest."""

    of: Expression
    index: Expression


@dataclass(frozen=True, slots=True)
class Call(Node):
    """``name(...)``: a macro, function or spline; only known at run time. Commas stand among the items."""

    of: Expression
    items: tuple[Item, ...]


@dataclass(frozen=True, slots=True)
class BuiltinCall(Node):
    """``sin(...)``, ``vrotate(...)``, ``concat(...)``: a keyword with arguments."""

    name: str
    items: tuple[Item, ...]


@dataclass(frozen=True, slots=True)
class FunctionLiteral(Node):
    """``function (a, b) { body }``. ``parameters`` None stands for x, y, z; ``source`` None for a block's body.

    ``size`` holds W and H of ``function W, H { ... }``.
    """

    parameters: tuple[str, ...] | None
    body: Expression | FunctionBlock | FunctionText
    source: FunctionText | None
    size: tuple[Expression, Expression] | None = None


@dataclass(frozen=True, slots=True)
class FunctionText(Node):
    """The body of a function as it is written: what runs must read it, with the directives and macros in it."""

    text: str


@dataclass(frozen=True, slots=True)
class FunctionName(Node):
    """A name in a function's body that was read by what runs."""

    name: str


@dataclass(frozen=True, slots=True)
class FunctionBlock(Node):
    """``pattern { ... }``, ``pigment``, ``transform``, ``spline`` or ``internal(N)`` as a function's body."""

    name: str
    items: tuple[Item, ...]


# --- items that are not expressions ---


@dataclass(frozen=True, slots=True)
class Keyword(Node):
    """A keyword standing by itself."""

    name: str


@dataclass(frozen=True, slots=True)
class Block(Node):
    """``{ ... }``; the keyword before it is the item before it."""

    items: tuple[Item, ...]
    end_line: int
    end_column: int


@dataclass(frozen=True, slots=True)
class LooseBrace(Node):
    """A brace whose partner lies outside the directive body that it stands in."""

    opening: bool


@dataclass(frozen=True, slots=True)
class LooseParen(Node):
    """The ``)`` that closes a `FileWriteOpen`."""


@dataclass(frozen=True, slots=True)
class Statements(Node):
    """Many statements alike in a row: what differs are the numbers (see `statements.Run`)."""

    shapes: tuple[tuple[Item, ...], ...]
    order: tuple[int, ...]
    lines: tuple[int, ...]
    numbers: tuple[NDArray[np.float64], ...]


@dataclass(frozen=True, slots=True)
class LooseOperator(Node):
    """An operator one of whose operands a directive supplies: ``(2 * #if (A) 3 #else 4 #end)``."""

    operator: Literal["+", "-", "*", "/", "!"]


@dataclass(frozen=True, slots=True)
class Bracket(Node):
    """``[ ... ]``."""

    items: tuple[Item, ...]


@dataclass(frozen=True, slots=True)
class Punctuation(Node):
    """``,`` ``;`` or ``:`` (in dictionaries)."""

    text: Literal[",", ";", ":", "="]


@dataclass(frozen=True, slots=True, eq=False)
class BulkVectors(Node):
    """A long run of literal vectors of equal size, commas or none between: shape (n, size)."""

    values: NDArray[np.float64]
    trailing_comma: bool

    def vectors(self) -> Iterator[Vector]:
        """Each vector as an item of its own."""
        for row in self.values.tolist():
            terms = (Number(self.line, self.column, value) for value in row)
            yield Vector(self.line, self.column, tuple(terms))


@dataclass(frozen=True, slots=True)
class Fault(Node):
    """A body of a directive that is not SDL: an error if it is reached."""

    error: SdlSyntaxError


@dataclass(frozen=True, slots=True)
class File:
    """A whole file."""

    path: str
    items: tuple[Item, ...]


Expression: TypeAlias = (
    Number
    | Hole
    | String
    | Name
    | Scoped
    | ConstantWord
    | Vector
    | Unary
    | Binary
    | Conditional
    | Paren
    | Group
    | Member
    | Subscript
    | Call
    | BuiltinCall
    | FunctionLiteral
)

Item: TypeAlias = (
    Expression
    | Keyword
    | Block
    | LooseBrace
    | LooseParen
    | LooseOperator
    | Bracket
    | Punctuation
    | BulkVectors
    | Fault
    | Statements
    | FunctionName
    | Directive
)
