"""Forms of the language, as trees written out in short."""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np
import pytest
from minipov.grammar import SdlSyntaxError, parse, tree
from minipov.grammar.lexer import tokenize, unescape
from minipov.grammar.text import decode


def short(node: Any) -> str:
    """A node as an s-expression without positions."""
    if isinstance(node, tuple):
        return "[" + " ".join(short(n) for n in node) + "]"
    if not is_dataclass(node):
        return repr(node)
    hidden = {"line", "column", "end_line", "end_column", "span"}
    parts = [short(getattr(node, f.name)) for f in fields(node) if f.name not in hidden]
    match node:
        case tree.Number(value=value):
            return f"{value:g}"
        case tree.Name(name=name) | tree.ConstantWord(name=name):
            return name
        case tree.Keyword(name=name):
            return f":{name}"
        case tree.Punctuation(text=text):
            return text
        case tree.Binary(operator=operator, left=left, right=right):
            return f"({operator} {short(left)} {short(right)})"
        case _:
            return f"({type(node).__name__} {' '.join(parts)})"


CASES = {
    "1 2": "1 2",
    "0 -1": "(- 0 1)",
    "y -1": "(- y 1)",
    "-V.y": "(Unary '-' (Member V 'y'))",
    "1+2*3": "(+ 1 (* 2 3))",
    "2*S(1 2)": "(* 2 (Call S [1 2]))",
    "(1<2<3)": "(Paren (< (< 1 2) 3))",
    "(1|0&0)": "(Paren (& (| 1 0) 0))",
    "(0?1:1?2:3)": "(Paren (Conditional 0 1 (Conditional 1 2 3)))",
    "!0*5": "(* (Unary '!' 0) 5)",
    "<1,2>": "(Vector [1 , 2])",
    "<-1 -2, 3>": "(Vector [(- (Unary '-' 1) 2) , 3])",
    "abs(1<2)": "(BuiltinCall 'abs' [(< 1 2)])",
    "rgb x<y": ":rgb (< x y)",
    "color red 0.5": ":color :red 0.5",
    "A[1][2].x": "(Member (Subscript (Subscript A 1) 2) 'x')",
    "[0 rgb 1]": "(Bracket [0 :rgb 1])",
    "sphere{0,1}": ":sphere (Block [0 , 1])",
    "#declare A = 1;": "(Declare False [A] '' False False None [] False) 1 ;",
    "#  local\tA[0] = B": "(Declare True [(Subscript A 0)] '' False False None [] False) B",
    "#if(1) a #elseif(2) b #else c #end": "(If [(Branch 1 [a] None) (Branch 2 [b] None)] [c])",
    "#ifndef(A) #end": "(If [(Branch A [] False)] None)",
    "#switch(1) #case(2) a #break #range(3,4) b #else c #end": (
        "(Switch 1 [(Case 2 None [a (Break )]) (Case 3 4 [b]) (Case None None [c])])"
    ),
    "#while(A<1) b #end": "(While (< A 1) [b])",
    "#for(I,1,9,2) a #end": "(For 'I' 1 9 2 [a])",
    "#macro M(a b,c) a #end": "(Macro 'M' ['a' 'b' 'c'] [False False False] [a])",
    "#if(1) merge { #else union { #end a }": (
        "(If [(Branch 1 [:merge (LooseBrace True)] None)] [:union (LooseBrace True)]) a (LooseBrace False)"
    ),
    "(#if(1) 1 #else 2 #end)": "(Group [(If [(Branch 1 [1] None)] [2])])",
    "function{x*x-1}": "(FunctionLiteral None (- (* x x) 1) (FunctionText 'x*x-1') None)",
    "function(a,b){a<b | a&b}": "(FunctionLiteral ['a' 'b'] (| (< a b) (& a b)) (FunctionText 'a<b | a&b') None)",
    "function{pattern{bozo}}": "(FunctionLiteral None (FunctionBlock 'pattern' [:bozo]) None None)",
    "function{internal(3)}": "(FunctionLiteral None (FunctionBlock 'internal' [3]) None None)",
    "function{#if(1)x#end}": "(FunctionLiteral None (FunctionText '#if(1)x#end') (FunctionText '#if(1)x#end') None)",
    "function 9,8{x}": "(FunctionLiteral None x (FunctionText 'x') [9 8])",
    "#write(F,1,uint8 2)": "(FileWrite 'F' [, 1 , :uint8 2])",
    "#read(F,A,B[1])": "(FileRead 'F' [A (Subscript B 1)])",
    '#fopen F "a" write': "(FileOpen 'F' (String 'a') 'write')",
    "declare A = 1": "(Declare False [A] '' False False None [] True) 1",
    '#declare deprecated once "t" A = 1': "(Declare False [A] '' True True (String 't') [] False) 1",
}


@pytest.mark.parametrize(("text", "expected"), CASES.items())
def test_forms(text: str, expected: str) -> None:
    assert " ".join(short(item) for item in parse(text).items) == expected


def test_comments_nest_and_strings_hide_them() -> None:
    assert [str(t) for t in tokenize('a /* b /* c */ d */ "/*" // e\n f')] == ["a", "/*", "f"]


def test_positions_count_lines_and_columns_from_one() -> None:
    sphere = parse("/* a\nb */\n  sphere { 0, 1 }").items[0]
    assert isinstance(sphere, tree.Keyword)
    assert (sphere.line, sphere.column) == (3, 3)


def test_a_long_run_of_vectors_is_one_node() -> None:
    run = ",\n".join(f"<{i}, -{i}.5, 1e-{i}>" for i in range(100))
    (mesh, block) = parse(f"vertex_vectors {{ 100, {run} }} sphere {{ 0, 1 }}").items[:2]
    assert isinstance(mesh, tree.Keyword)
    assert isinstance(block, tree.Block)
    bulk = block.items[2]
    assert isinstance(bulk, tree.BulkVectors)
    assert bulk.values.shape == (100, 3)
    assert np.allclose(bulk.values[7], (7, -7.5, 1e-7))


def test_words_of_38_are_names_before() -> None:
    assert isinstance(parse("lemon").items[0], tree.Name)
    assert isinstance(parse("#version 3.8; lemon").items[-1], tree.Keyword)
    assert isinstance(parse("prefix").items[0], tree.Name)


def test_escapes() -> None:
    assert unescape(r"a\n\"\u0041\\") == 'a\n"A\\'


def test_decoding() -> None:
    assert decode(b"\xef\xbb\xbfa\xc3\xa9") == "aé"
    assert decode(b"a\xe9") == "aé"


def test_lines_end_as_on_any_system() -> None:
    assert decode(b"1\n2\r\n3\n\r4\r5\r\r7") == "1\n2\n3\n4\n5\n\n7"


ERRORS = {
    "#if (1) a": (1, 1, "'#if' is never closed", "#end"),
    "sphere {\n <0,0, }": (2, 8, "unexpected '}', expected '>'", "line 2"),
    "#declare = 3;": (1, 10, "unexpected '='", None),
    "#end": (1, 1, "closes nothing", None),
    "#declare A = (1+2;": (1, 14, "'(' is never closed", ")"),
    "#foo": (1, 1, "unknown directive '#foo'", None),
    '\n "abc': (2, 2, "string is never closed", '"'),
    "1.2.3": (1, 1, "malformed number '1.2.3'", None),
    "/* x": (1, 1, "comment is never closed", "*/"),
    "color_map { [0 rgb 1 }": (1, 22, "expected ']'", "line 1"),
}


@pytest.mark.parametrize(("text", "expected"), ERRORS.items())
def test_errors_say_where_and_what(text: str, expected: tuple[int, int, str, str | None]) -> None:
    line, column, message, hint = expected
    with pytest.raises(SdlSyntaxError) as caught:
        parse(text, "f.pov")
    error = caught.value
    assert (error.path, error.line, error.column) == ("f.pov", line, column)
    assert message in error.message
    if hint:
        assert hint in (error.hint or "")
