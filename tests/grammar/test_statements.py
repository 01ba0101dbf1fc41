"""Statements alike in a row mean what they mean one by one."""

from __future__ import annotations

import random
from dataclasses import replace
from typing import Any

import pytest
from minipov.grammar.parser import parse
from minipov.grammar.tree import Statements
from minipov.interpreter import Messages, SdlError, load_text
from minipov.tracer.objects import Object

HEAD = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#declare T = texture { pigment { rgb x } }\n"
MACRO = "#macro Ball(P, R, C) sphere { P, R pigment { rgb C } }\n#end\n"

SHAPES = {
    "sphere": "sphere{<%f,%f,%f>,%f texture{pigment{color rgb <%f,%f,%f>} finish{phong 0.5}}}",
    "no commas": "sphere { <%f %f %f> %f texture { T } }",
    "cylinder": "cylinder {<%f,%f,%f>, <%f, 3, 4>, %f open pigment { rgbt <%f,0,0,%f> }}",
    "box moved": "box { 0, <%f,%f,%f> translate <%f,1,2> rotate y*%f }",
    "arithmetic": "sphere { <%f,%f,%f>*2 + x, abs(%f) }",
    "triangle": "triangle { <%f,%f,%f>, <%f,1,0>, <%f,0,1> pigment { rgb 1 } }",
    "union": "union { sphere { <%f,%f,%f>, 1 } box { 0, <%f,1,1> } texture { T scale %f } }",
    "macro": "Ball(<%f,%f,%f>, %f <%f,0,1>)",
    "light": "light_source { <%f,%f,%f>, rgb <%f,1,1> spotlight radius 5 point_at %f }",
}


def plain(thing: Any) -> Any:
    """An object without the place where it was made."""
    if isinstance(thing, Object):
        children = getattr(thing.shape, "children", None)
        shape = replace(thing.shape, children=tuple(map(plain, children))) if children else thing.shape
        return replace(thing, source="", shape=shape)
    return thing


def statements(shape: str, count: int = 60) -> list[str]:
    numbers = random.Random(shape)
    signs = (-1, 1) if ", " in shape or ",%" in shape else (1,)
    return [
        shape % tuple(numbers.uniform(0.1, 3) * numbers.choice(signs) for _ in range(shape.count("%f")))
        for _ in range(count)
    ]


def scene_of(text: str) -> list[Any]:
    scene = load_text(HEAD + MACRO + text)
    return [plain(thing) for thing in (*scene.objects, *scene.lights)]


@pytest.mark.parametrize("name", SHAPES)
def test_same_scene(name: str) -> None:
    lines = statements(SHAPES[name])
    assert scene_of("\n".join(lines)) == scene_of("\n#declare Between = 1;\n".join(lines))


def test_shapes_mixed_and_inside_a_block() -> None:
    shapes = [statements(SHAPES[name]) for name in ("sphere", "cylinder", "box moved", "triangle")]
    lines = [line for row in zip(*shapes, strict=True) for line in row]
    together, apart = "\n".join(lines), "\n#declare Between = 1;\n".join(lines)
    assert scene_of(f"union {{ {together} }}") == scene_of(f"union {{ {apart} }}")


def test_they_are_one_item() -> None:
    file = parse("\n".join(statements(SHAPES["sphere"])), runs=True)
    assert [type(item) for item in file.items] == [Statements]
    assert len(parse("\n".join(statements(SHAPES["sphere"], 10)), runs=True).items) > 10


def test_every_object_knows_its_line() -> None:
    scene = load_text("\n".join(statements(SHAPES["sphere"])))
    assert [thing.source for thing in scene.objects] == [f"scene.pov:{line}" for line in range(1, 61)]


def test_an_error_is_reported_in_its_line() -> None:
    lines = [f"sphere {{ 0, ln({number}) }}" for number in range(99, -1, -1)]
    with pytest.raises(SdlError) as raised:
        load_text("\n".join(lines))
    assert raised.value.place == ("scene.pov", 100, 13)


def test_a_warning_is_said_in_its_line() -> None:
    lines = [f"cylinder {{ 0, {number}*y, 1 }}" for number in range(99, -1, -1)]
    with pytest.raises(SdlError) as raised:
        load_text("\n".join(lines))
    assert raised.value.place[1] == 100
    messages = Messages()
    load_text("\n".join(f"triangle {{ 0, x, {number}*y }}" for number in range(50, -1, -1)), messages=messages)
    assert [warning.place[1] for warning in messages.all if "triangle" in warning.text] == [51]
