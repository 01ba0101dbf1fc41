"""Lark's callbacks: one method per rule of sdl.lark, each building a node of `tree`.

A method receives the rule's children: tokens, and what the methods of inner rules returned.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeAlias

from lark import Token, Transformer
from minipov.grammar import tree
from minipov.grammar.errors import SdlSyntaxError
from minipov.grammar.statements import Run

Children: TypeAlias = list[Any]


class _Several(tuple[Any, ...]):
    """Items that one rule found together; the list around them takes them one by one."""


def _items(children: Children) -> tuple[tree.Item, ...]:
    flat: list[tree.Item] = []
    for child in children:
        if type(child) is _Several:
            flat.extend(child)
        else:
            flat.append(child)
    return tuple(flat)


class Builder(Transformer[Token, Any]):
    """Builds the tree while Lark parses."""

    def __init__(self, parse: Callable[[str, bool], tuple[tree.Item, ...]]) -> None:
        super().__init__(visit_tokens=False)
        self.parse = parse

    def start(self, c: Children) -> Any:
        return _items(c)

    # --- items ---

    def block(self, c: Children) -> Any:
        first, last = c[0], c[-1]
        return tree.Block(first.line, first.column, _items(c[1:-1]), last.line, last.column)

    def keyword(self, c: Children) -> Any:
        return tree.Keyword(c[0].line, c[0].column, str(c[0]))

    def punctuation(self, c: Children) -> Any:
        return tree.Punctuation(c[0].line, c[0].column, c[0].value)

    def rgb(self, c: Children) -> Any:
        return _Several((self.keyword(c), *c[1:]))

    def bracket(self, c: Children) -> Any:
        return tree.Bracket(c[0].line, c[0].column, _items(c[1:-1]))

    def loose(self, c: Children) -> Any:
        return tree.LooseBrace(c[0].line, c[0].column, c[0].type == "LOOSE_LBRACE")

    def loose_paren(self, c: Children) -> Any:
        return tree.LooseParen(c[0].line, c[0].column)

    def loose_operator(self, c: Children) -> Any:
        return tree.LooseOperator(c[0].line, c[0].column, c[0].value)

    def dotted_key(self, c: Children) -> Any:
        return tree.Bracket(c[0].line, c[0].column, (tree.String(c[0].line, c[0].column, str(c[1])),))

    def statements(self, c: Children) -> Any:
        run: Run = c[0].value
        shapes = []
        for shape, (line, column) in zip(run.shapes, run.starts, strict=True):
            shapes.append(self.parse("\n" * (line - 1) + " " * (column - 1) + shape, run.version_38))
        return tree.Statements(c[0].line, c[0].column, tuple(shapes), run.order, run.lines, run.numbers)

    def bulk(self, c: Children) -> Any:
        values, trailing_comma = c[0].value
        return tree.BulkVectors(c[0].line, c[0].column, values, trailing_comma)

    def fault(self, c: Children) -> Any:
        error = c[0].value
        return tree.Fault(error.line, error.column, error)

    # --- expressions ---

    def hole(self, c: Children) -> Any:
        return tree.Hole(c[0].line, c[0].column, int(c[0]))

    def number(self, c: Children) -> Any:
        return tree.Number(c[0].line, c[0].column, float(c[0]))

    def string(self, c: Children) -> Any:
        return tree.String(c[0].line, c[0].column, str(c[0]))

    def constant(self, c: Children) -> Any:
        return tree.ConstantWord(c[0].line, c[0].column, str(c[0]))

    def name(self, c: Children) -> Any:
        return tree.Name(c[0].line, c[0].column, str(c[0]))

    def scoped(self, c: Children) -> Any:
        return tree.Scoped(c[0].line, c[0].column, c[0].value, str(c[2]))

    def vector(self, c: Children) -> Any:
        return tree.Vector(c[0].line, c[0].column, _items(c[1:-1]))

    def unary(self, c: Children) -> Any:
        return tree.Unary(c[0].line, c[0].column, c[0].value, c[1])

    def binary(self, c: Children) -> Any:
        left, operator, right = c
        return tree.Binary(left.line, left.column, str(operator), left, right)

    def conditional(self, c: Children) -> Any:
        condition, _, yes, _, no = c
        return tree.Conditional(condition.line, condition.column, condition, yes, no)

    def paren(self, c: Children) -> Any:
        return tree.Paren(c[0].line, c[0].column, c[1])

    def group(self, c: Children) -> Any:
        def item(child: Any) -> Any:
            if not isinstance(child, Token):
                return child
            return self.loose_operator([child]) if child.type == "LOOSE_OPERATOR" else self.punctuation([child])

        return tree.Group(c[0].line, c[0].column, _items([item(child) for child in c[1:-1]]))

    def member_name(self, c: Children) -> Any:
        return c[0]

    def member(self, c: Children) -> Any:
        return tree.Member(c[0].line, c[0].column, c[0], str(c[2]), c[2].line, c[2].column)

    def subscript(self, c: Children) -> Any:
        return tree.Subscript(c[0].line, c[0].column, c[0], c[2])

    def call(self, c: Children) -> Any:
        return tree.Call(c[0].line, c[0].column, c[0], _items(c[2:-1]))

    def builtin(self, c: Children) -> Any:
        return tree.BuiltinCall(c[0].line, c[0].column, str(c[0]), _items(c[2:-1]))

    def builtin_of_group(self, c: Children) -> Any:
        return tree.BuiltinCall(c[0].line, c[0].column, str(c[0]), (c[1],))

    # --- SDL functions ---

    def any_name(self, c: Children) -> Any:
        return str(c[0])

    def parameter_names(self, c: Children) -> Any:
        return tuple(name for name in c if not isinstance(name, Token))

    def function_literal(self, c: Children) -> Any:
        parameters = c[2] if len(c) == 7 else None
        return tree.FunctionLiteral(c[0].line, c[0].column, parameters, c[-2], self._source(c))

    def image_function(self, c: Children) -> Any:
        return tree.FunctionLiteral(c[0].line, c[0].column, None, c[-2], self._source(c), (c[1], c[3]))

    def _source(self, c: Children) -> tree.FunctionText | None:
        if isinstance(c[-2], tree.FunctionBlock):
            return None
        return tree.FunctionText(c[-3].line, c[-3].column + 1, str(c[-3]))

    def function_text(self, c: Children) -> Any:
        return tree.FunctionText(c[0].line, c[0].column, str(c[0]))

    def function_token(self, c: Children) -> Any:
        text = str(c[0])
        if text[0].isalpha():
            return self.keyword(c)
        return self.number(c) if text[-1].isdigit() or (text[-1] == "." and len(text) > 1) else self.punctuation(c)

    def function_name(self, c: Children) -> Any:
        return tree.FunctionName(c[0].line, c[0].column, str(c[0]))

    def function_block(self, c: Children) -> Any:
        return tree.FunctionBlock(c[0].line, c[0].column, str(c[0]), c[1].items)

    def function_internal(self, c: Children) -> Any:
        return tree.FunctionBlock(c[0].line, c[0].column, str(c[0]), (c[2],))

    # --- declarations ---

    def declare(self, c: Children) -> Any:
        bare = not c[0].startswith("#")
        return tree.Declare(c[0].line, c[0].column, c[0].type == "LOCAL", (c[-2],), bare=bare)

    def declare_deprecated(self, c: Children) -> Any:
        once = any(isinstance(t, Token) and t.type == "ONCE" for t in c)
        texts = [self.string([t]) for t in c if isinstance(t, Token) and t.type == "STRING"]
        local = c[0].type == "LOCAL"
        text = texts[0] if texts else None
        return tree.Declare(c[0].line, c[0].column, local, (c[-2],), "", True, once, text)

    def declare_tuple(self, c: Children) -> Any:
        targets, optional = c[2]
        return tree.Declare(c[0].line, c[0].column, c[0].type == "LOCAL", targets, form=c[1].value, optional=optional)

    def targets(self, c: Children) -> Any:
        """Targets between commas; an empty place between two commas is None."""
        targets: list[Any] = []
        optional: list[bool] = []
        filled = False
        for child in (*c, None):
            if isinstance(child, Token) or child is None:
                if not filled and child is not None:
                    targets.append(None)
                    optional.append(False)
                filled = False
            else:
                targets.append(child[1])
                optional.append(child[0])
                filled = True
        return tuple(targets), tuple(optional)

    def optional_target(self, c: Children) -> Any:
        return len(c) == 2, c[-1]

    def reserved_target(self, c: Children) -> Any:
        return tree.ConstantWord(c[0].line, c[0].column, str(c[0]))

    def undef(self, c: Children) -> Any:
        return tree.Undef(c[0].line, c[0].column, c[1])

    # --- control flow ---

    def if_head(self, c: Children) -> Any:
        defined = {"IF": None, "IFDEF": True, "IFNDEF": False}[c[0].type]
        return c[0].line, c[0].column, c[2], defined

    # Lark hands `if`, `for`, ... over under these names; they cannot be written as `def`.

    def _if(self, c: Children) -> Any:
        line, column, condition, defined = c[0]
        at = next((i for i, child in enumerate(c) if type(child) in (tree.Branch, _Else)), len(c) - 1)
        first = tree.Branch(line, column, condition, _items(c[1:at]), defined)
        others = [child for child in c[at:-1] if type(child) is tree.Branch]
        otherwise = next((child.items for child in c[at:-1] if type(child) is _Else), None)
        return tree.If(line, column, (first, *others), otherwise)

    def elseif(self, c: Children) -> Any:
        return tree.Branch(c[0].line, c[0].column, c[2], _items(c[4:]))

    def _else(self, c: Children) -> Any:
        return _Else(_items(c[1:]))

    def switch(self, c: Children) -> Any:
        return tree.Switch(c[0].line, c[0].column, c[2], tuple(c[4:-1]))

    def case(self, c: Children) -> Any:
        if c[0].type == "CASE":
            return tree.Case(c[0].line, c[0].column, c[2], None, _items(c[4:]))
        return tree.Case(c[0].line, c[0].column, c[2], c[4], _items(c[6:]))

    def case_else(self, c: Children) -> Any:
        return tree.Case(c[0].line, c[0].column, None, None, _items(c[1:]))

    def _while(self, c: Children) -> Any:
        return tree.While(c[0].line, c[0].column, c[2], _items(c[4:-1]))

    def _for(self, c: Children) -> Any:
        has_step = isinstance(c[7], Token) and c[7].type == "COMMA"
        step, rest = (c[8], c[10:-1]) if has_step else (None, c[8:-1])
        return tree.For(c[0].line, c[0].column, str(c[2]), c[4], c[6], step, _items(rest))

    def _break(self, c: Children) -> Any:
        return tree.Break(c[0].line, c[0].column)

    def any_parameter(self, c: Children) -> Any:
        return len(c) == 2, str(c[-1])

    def macro_parameters(self, c: Children) -> Any:
        return [child for child in c if not isinstance(child, Token)]

    def macro(self, c: Children) -> Any:
        parameters = c[3]
        names = tuple(name for _, name in parameters)
        optional = tuple(flag for flag, _ in parameters)
        return tree.Macro(
            c[0].line, c[0].column, str(c[1]), names, optional, _items(c[5:-1]), (c[4].end_pos, c[-1].start_pos)
        )

    # --- other directives ---

    def include(self, c: Children) -> Any:
        return tree.Include(c[0].line, c[0].column, c[1])

    def version(self, c: Children) -> Any:
        unofficial = isinstance(c[1], Token)
        return tree.Version(c[0].line, c[0].column, c[2] if unofficial else c[1], unofficial)

    def default(self, c: Children) -> Any:
        return tree.Default(c[0].line, c[0].column, c[1])

    def print(self, c: Children) -> Any:
        return tree.Print(c[0].line, c[0].column, c[0].type.lower(), c[1])

    def obsolete(self, c: Children) -> Any:
        return tree.Obsolete(c[0].line, c[0].column, c[0].type.lower(), c[1])

    def fopen(self, c: Children) -> Any:
        mode = str(c[3])
        if mode not in {"read", "write", "append"}:
            raise SdlSyntaxError(f"expected read, write or append, found '{mode}'", "", c[3].line, c[3].column)
        return tree.FileOpen(c[0].line, c[0].column, str(c[1]), c[2], mode)  # type: ignore[arg-type]  # checked above

    def fclose(self, c: Children) -> Any:
        return tree.FileClose(c[0].line, c[0].column, str(c[1]))

    def read(self, c: Children) -> Any:
        targets = tuple(child for child in c[3:] if not isinstance(child, Token))
        return tree.FileRead(c[0].line, c[0].column, str(c[2]), targets)

    def write(self, c: Children) -> Any:
        return tree.FileWrite(c[0].line, c[0].column, str(c[2]), _items(c[3:-1]))

    def write_open(self, c: Children) -> Any:
        return tree.FileWriteOpen(c[0].line, c[0].column, str(c[2]))


class _Else:
    """What ``#else`` guards, on its way to its `tree.If`."""

    __slots__ = ("items",)

    def __init__(self, items: tuple[tree.Item, ...]) -> None:
        self.items = items


for _word in ("if", "else", "while", "for", "break"):
    setattr(Builder, _word, getattr(Builder, f"_{_word}"))
