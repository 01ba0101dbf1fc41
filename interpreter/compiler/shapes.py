"""What can be told of a tree before it is compiled: constants, macro calls at an edge, where one value ends."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, Final

from minipov.grammar import tree
from minipov.grammar.lexer import unescape
from minipov.interpreter.colors import COLOR_WORDS
from minipov.interpreter.values import CONSTANT_WORDS, Vector

ARITHMETIC: Final = frozenset("+-*/")
EXPRESSIONS: Final = (
    tree.Number, tree.Hole, tree.String, tree.Name, tree.Scoped, tree.ConstantWord, tree.Vector, tree.Unary,
    tree.Binary, tree.Conditional, tree.Paren, tree.Group, tree.Member, tree.Subscript, tree.Call, tree.BuiltinCall,
    tree.FunctionLiteral,
)  # fmt: skip
DIRECTIVES: Final = (
    tree.Declare, tree.Undef, tree.Include, tree.If, tree.Switch, tree.While, tree.For, tree.Break, tree.Macro,
    tree.Default, tree.Version, tree.Print, tree.FileOpen, tree.FileClose, tree.FileRead, tree.FileWrite,
    tree.FileWriteOpen, tree.Obsolete,
)  # fmt: skip


def constant(node: tree.Item) -> Any:
    """The float, `Vector` or str that an expression always is, or None."""
    match node:
        case tree.Number(value=value):
            return value
        case tree.String(raw=raw) if raw.isascii():
            return unescape(raw)
        case tree.ConstantWord(name=name):
            return CONSTANT_WORDS.get(name)
        case tree.Paren(inner=inner):
            return constant(inner)
        case tree.Unary(operator="-", operand=operand):
            value = constant(operand)
            return -value if isinstance(value, float | Vector) else None
        case tree.Binary(operator=operator, left=left, right=right) if operator in ARITHMETIC:
            return _folded(operator, constant(left), constant(right))
        case tree.Vector(items=items):
            if any(isinstance(item, tree.Vector) for item in items):
                return None
            terms = [constant(item) for item in items if not is_comma(item)]
            return Vector(terms) if len(terms) > 1 and all(type(term) is float for term in terms) else None
    return None


def _folded(operator: str, left: Any, right: Any) -> Any:
    if not isinstance(left, float | Vector) or not isinstance(right, float | Vector):
        return None
    try:
        match operator:
            case "+":
                return left + right
            case "-":
                return left - right
            case "*":
                return left * right
        return left / right if isinstance(right, float) and right else None
    except TypeError:
        return None


def parted(item: tree.Item) -> tuple[tree.Expression, tree.Expression] | None:
    """A function or string that a sum begins with, and the signed rest: ``function {...} -0.5`` are two items."""
    if not isinstance(item, tree.Binary) or item.operator not in ("+", "-"):
        return None
    if isinstance(item.left, tree.FunctionLiteral | tree.String):
        return item.left, tree.Unary(item.line, item.column, "-" if item.operator == "-" else "+", item.right)
    inner = parted(item.left)
    return inner and (inner[0], replace(item, left=inner[1]))


def is_comma(item: tree.Item) -> bool:
    """Whether an item is a comma."""
    return isinstance(item, tree.Punctuation) and item.text == ","


def is_semicolon(item: tree.Item) -> bool:
    """Whether an item is a semicolon."""
    return isinstance(item, tree.Punctuation) and item.text == ";"


def may_splice(node: tree.Item) -> bool:
    """Whether an expression may turn out to be several items, because a macro call stands at its edge."""
    match node:
        case tree.Call():
            return True
        case tree.Unary(operand=inner) | tree.Member(of=inner):
            return may_splice(inner)
        case tree.Binary(operator=operator, left=left, right=right):
            return operator in ARITHMETIC and (may_splice(left) or may_splice(right))
    return False


def never_color(node: tree.Item) -> bool:
    """Whether an expression cannot have five terms."""
    match node:
        case tree.Number() | tree.Hole() | tree.String() | tree.Member() | tree.BuiltinCall() | tree.ConstantWord():
            return True
        case tree.Paren(inner=inner) | tree.Unary(operand=inner):
            return never_color(inner)
        case tree.Binary(left=left, right=right) | tree.Conditional(yes=left, no=right):
            return never_color(left) and never_color(right)
        case tree.Vector(items=items):
            terms = [item for item in items if not is_comma(item)]
            return len(terms) < 5 and all(isinstance(term, EXPRESSIONS) and not may_splice(term) for term in terms)
    return False


def value_extent(items: Sequence[tree.Item], start: int) -> int | None:
    """Where the one value that begins at ``items[start]`` ends; None if only the running program can tell."""
    if start >= len(items):
        return None
    first = items[start]
    if isinstance(first, EXPRESSIONS):
        after = items[start + 1] if start + 1 < len(items) else None
        if isinstance(first, tree.Call) and (isinstance(after, tree.Block | tree.LooseBrace) or _is(after, "texture")):
            return None
        return start + 1
    if not isinstance(first, tree.Keyword):
        return None
    if first.name in COLOR_WORDS:
        return _color_extent(items, start)
    if first.name == "array":
        return _array_extent(items, start)
    if first.name == "dictionary" and not isinstance(_at(items, start + 1), tree.Block):
        return start + 1
    at = start
    while isinstance(_at(items, at + 1), tree.Block):
        at += 2
        if first.name != "texture" or not _is(_at(items, at), "texture"):
            break
    return None if at == start else at


def _at(items: Sequence[tree.Item], index: int) -> tree.Item | None:
    return items[index] if index < len(items) else None


def _is(item: tree.Item | None, word: str) -> bool:
    return isinstance(item, tree.Keyword) and item.name == word


def _color_extent(items: Sequence[tree.Item], start: int) -> int | None:
    at = start
    while at < len(items):
        item = items[at]
        if (isinstance(item, tree.Keyword) and item.name in COLOR_WORDS) or (
            isinstance(item, EXPRESSIONS) and isinstance(items[at - 1], tree.Keyword)
        ):
            at += 1
        else:
            break
    return None if isinstance(items[at - 1], tree.Keyword) else at


def _array_extent(items: Sequence[tree.Item], start: int) -> int | None:
    at = start + 1
    while _is(_at(items, at), "mixed"):
        at += 1
    while isinstance(_at(items, at), tree.Bracket):
        at += 1
    while _is(_at(items, at), "optional"):
        at += 1
    return at + 1 if isinstance(_at(items, at), tree.Block) else at


def argument_groups(items: Sequence[tree.Item]) -> list[Sequence[tree.Item]] | None:
    """The items of each argument of a call or element of a list; None if only the running program can tell.

    Commas are optional between arguments; two in a row enclose an empty one.
    """
    groups: list[Sequence[tree.Item]] = []
    at = 0
    after_comma = True
    while at < len(items):
        bulk = items[at]
        if isinstance(bulk, tree.BulkVectors):
            groups.extend((vector,) for vector in bulk.vectors())
            after_comma = bulk.trailing_comma
            at += 1
            continue
        if is_comma(items[at]):
            if after_comma:
                groups.append(())
            after_comma = True
            at += 1
            continue
        end = at + 1 if _is_lone_word(items, at) else value_extent(items, at)
        if end is None:
            return None
        groups.append(items[at:end])
        after_comma = False
        at = end
    return groups


def _is_lone_word(items: Sequence[tree.Item], at: int) -> bool:
    item = items[at]
    following = _at(items, at + 1)
    return isinstance(item, tree.Keyword) and item.name.endswith("_spline") and not isinstance(following, tree.Block)
