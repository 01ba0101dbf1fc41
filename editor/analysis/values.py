"""What a declared name is worth, where that can be told without running the scene: numbers, vectors, colours, strings.

``#declare Size = 2*pi;`` shows as 6.28319. Names are looked up through the includes; a name that is declared twice, or
that depends on anything that runs, has no value here.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import takewhile
from math import pi
from typing import Any, Final

from minipov.editor.analysis.document import Document
from minipov.editor.analysis.library import Library
from minipov.editor.analysis.names import Declaration, declarations
from minipov.editor.analysis.recovery import parse_tokens
from minipov.grammar import tree
from minipov.grammar.braces import mark_loose_braces
from minipov.grammar.lexer import unescape
from minipov.interpreter.runtime.builtins import BUILTINS
from minipov.interpreter.values import COMPONENTS, Vector

_DEEPEST: Final = 30
_LONGEST: Final = 200
"""Tokens of a declaration beyond which it is not looked into."""

_CONSTANTS: Final[dict[str, float | Vector]] = {
    "pi": pi, "tau": 2 * pi, "on": 1.0, "yes": 1.0, "true": 1.0, "off": 0.0, "no": 0.0, "false": 0.0,
    "x": Vector((1.0, 0.0, 0.0)), "y": Vector((0.0, 1.0, 0.0)), "z": Vector((0.0, 0.0, 1.0)),
}  # fmt: skip
_OPERATORS: Final[dict[str, Callable[[Any, Any], Any]]] = {
    "+": lambda a, b: a + b, "-": lambda a, b: a - b, "*": lambda a, b: a * b, "/": lambda a, b: a / b,
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Color:
    """A colour as its word (``rgb``, ``srgbt``) and terms say it."""

    word: str
    terms: Vector


class _NoValueError(Exception):
    """Only a run can tell."""


def value_of(library: Library, document: Document, declaration: Declaration) -> float | Vector | str | Color | None:
    """The value of a declared name, or None."""
    try:
        value: float | Vector | str | Color = _Evaluator(library, document).declared(document, declaration)
        return value
    except (_NoValueError, ArithmeticError, TypeError, ValueError, AttributeError, KeyError):
        return None


def shown(value: float | Vector | str | Color) -> str:
    """A value as SDL writes it."""
    if isinstance(value, Color):
        return f"{value.word} {shown(value.terms)}"
    if isinstance(value, Vector):
        return "<" + ", ".join(f"{term:g}" for term in value) + ">"
    return f'"{value}"' if isinstance(value, str) else f"{value:g}"


class _Evaluator:
    def __init__(self, library: Library, document: Document) -> None:
        self.library = library
        self.document = document
        self.depth = 0

    def declared(self, document: Document, declaration: Declaration) -> Any:
        same = [d for d in declarations(document) if d.name == declaration.name and d.scope == declaration.scope]
        self.depth += 1
        if declaration.kind != "value" or len(same) > 1 or self.depth > _DEEPEST:
            raise _NoValueError
        start, statement = document.at(declaration.start)
        tokens = [t for t in statement.tokens if declaration.from_ <= start + (t.start_pos or 0) < declaration.to]
        if len(tokens) > _LONGEST:
            raise _NoValueError
        items, _ = parse_tokens(mark_loose_braces(tokens), tokens[-1], statement)
        if not items or not isinstance(items[0], tree.Declare):
            raise _NoValueError
        value = self.items(items[1:])
        self.depth -= 1
        return value

    def items(self, items: Sequence[Any]) -> Any:
        """The value of a declaration: the items up to a semicolon."""
        value = list(takewhile(lambda item: not isinstance(item, tree.Punctuation), items))
        words = [item.name for item in takewhile(lambda item: isinstance(item, tree.Keyword), value)]
        if not words:
            return self.of(value[0]) if value else self.of(None)
        if words[0] in {"color", "colour"}:
            words, value = words[1:], value[1:]
            if not words and value:
                found = self.of(value[0])
                return found if isinstance(found, Color) else Color("rgbft", found)
        if words and words[0] in COMPONENTS:
            return Color("rgbft", self._components(value))
        if len(words) == 1 and len(value) >= 2 and words[0].endswith(("rgb", "rgbf", "rgbt", "rgbft")):
            found = self.of(value[1])
            size = len(words[0].removeprefix("s"))
            return Color(words[0], found if isinstance(found, Vector) else Vector((found,) * size))
        raise _NoValueError

    def _components(self, value: Sequence[Any]) -> Vector:
        """``red 1 green 0.5``."""
        terms = [0.0] * 5
        for word, node in zip(value[::2], value[1::2], strict=True):
            terms[COMPONENTS[word.name]] = self.of(node)
        return Vector(terms)

    def of(self, node: Any) -> Any:
        match node:
            case tree.Number(value=value):
                return value
            case tree.String(raw=raw):
                return unescape(raw)
            case tree.ConstantWord(name=name) if name in _CONSTANTS:
                return _CONSTANTS[name]
            case tree.Name(name=name):
                found = self.library.lookup(self.document, name, 0)
                if found is not None:
                    return self.declared(*found)
            case tree.Paren(inner=inner):
                return self.of(inner)
            case tree.Unary(operator="-", operand=operand):
                return -self.of(operand)
            case tree.Unary(operator="+", operand=operand):
                return self.of(operand)
            case tree.Binary(operator=operator, left=left, right=right) if operator in _OPERATORS:
                return _OPERATORS[operator](_plain(self.of(left)), _plain(self.of(right)))
            case tree.Vector(items=items):
                terms = [self.of(item) for item in items if not isinstance(item, tree.Punctuation)]
                if terms and all(isinstance(term, float) for term in terms):
                    return Vector(terms)
            case tree.Member(of=inner, name=name) if name in COMPONENTS:
                found = self.of(inner)
                return _plain(found)[COMPONENTS[name]]
            case tree.BuiltinCall(name=name, items=items) if name in BUILTINS and BUILTINS[name].pure:
                return BUILTINS[name].call(*(self.of(i) for i in items if not isinstance(i, tree.Punctuation)))
        raise _NoValueError


def _plain(value: Any) -> Any:
    """A colour as the vector that operators see."""
    return value.terms if isinstance(value, Color) else value
