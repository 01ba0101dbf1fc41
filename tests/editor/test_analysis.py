"""The analysis library by itself."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given, settings, strategies as st
from minipov.editor.analysis.checks import problems
from minipov.editor.analysis.document import Document
from minipov.editor.analysis.language import OBJECTS, SCENE, accepted
from minipov.editor.analysis.library import Library
from minipov.editor.analysis.names import globals_of
from minipov.editor.analysis.syntax import syntax_problems
from minipov.editor.analysis.values import shown, value_of

ERRORS = sorted((Path(__file__).parents[1] / "errors").glob("*.pov"))

MISTAKES = {
    "sphere { 0, 1 }": [],
    "sphere { <0, 0, }\nbox { 0, 1 }": [(1, "unexpected '}', expected '>'")],
    "sphere { 0, 1\n#declare A = 3;\nbox { 0, A }": [(1, "'{' is never closed")],
    "sphere { 0, 1 } }\nbox { 0, 1 }": [(1, "this '}' closes nothing")],
    "#if (1)\nsphere { 0, 1 }": [(1, "'#if' is never closed")],
    "#declare A = (1+2;\n#declare B = 3;": [(1, "this '(' is never closed")],
    "sphere { 0, @ }\nbox { 0, $ }": [(1, "unexpected character '@'"), (2, "unexpected character '$'")],
    "#declare = 1;\n#declare A = 2;\n#for (1)\n#end": [(1, "unexpected '='"), (3, "unexpected '1'")],
    "#if (1) union { #else merge { #end\nsphere { 0, 1 }\n}": [],
    "#if (1) union { #else merge { #end\nsphere { 0, 1 }": [],
    "#macro Open() union { #end\nOpen() sphere { 0, 1 }\n}": [],
    '#debug "abc\nsphere { 0, 1 }': [(1, "this string is never closed")],
    "/* a\nsphere { 0, 1 }": [(1, "this comment is never closed")],
}


@pytest.mark.parametrize(("text", "expected"), MISTAKES.items())
def test_mistakes(text: str, expected: list[tuple[int, str]]) -> None:
    document = Document(text)
    found = [(document.line_of(one.start) + 1, one.message) for one in syntax_problems(document)]
    assert [line for line, _ in found] == [line for line, _ in expected]
    for (_, message), (_, part) in zip(found, expected, strict=True):
        assert part in message


@pytest.mark.parametrize("file", ERRORS, ids=lambda file: file.stem)
def test_wrong_scenes_can_be_asked(file: Path) -> None:
    document = Library((Path("/usr/share/povray-3.7/include"),)).get(str(file))
    assert document is not None
    found = problems(document, Library(()))
    assert all(0 <= one.start <= one.end <= len(document.text) for one in found)


PIECES = ["{", "}", "(", ")", "<", ">", "[", "#if (1)", "#else", "#end",
          '"', "/*", "*/", "//", "\n", "sphere", "A", "1",
          "#declare B = ", "#macro M(P)", "=", ";", ",", " ", "@", "#", "1.2.3", "function", "rgb", "."]  # fmt: skip


EDITS = st.tuples(st.floats(0, 1), st.integers(0, 40), st.lists(st.sampled_from(PIECES), max_size=4))
START = """#declare A = 1;
sphere { <0, A, 0>, 1 }
#if (A)
  box { 0, 1 }
#end
M(1)
/* x */ union { #while (1) #end }
"""


@settings(max_examples=300, deadline=None)
@given(st.lists(EDITS, max_size=4))
def test_an_edit_gives_what_reading_anew_gives(edits: list[tuple[float, int, list[str]]]) -> None:
    text = START
    document = Document(text)
    for where, length, pieces in edits:
        at = int(where * len(text))
        text = text[:at] + "".join(pieces) + text[at + length :]
        document = document.edited(text)
        fresh = Document(text)
        assert [one.text for one in document.statements] == [one.text for one in fresh.statements]
        assert syntax_problems(document) == syntax_problems(fresh)


VALUES = {
    "2*pi": "6.28319",
    "<1, 2, 3>*2": "<2, 4, 6>",
    "rgb <1, 0.5, 0>": "rgb <1, 0.5, 0>",
    "color red 1 green 0.5": "rgbft <1, 0.5, 0, 0, 0>",
    "B + 1": "4",
    "vlength(<3, 4, 0>)": "5",
    '"text"': '"text"',
    "-C.y": "-2",
    "rand(S)": None,
    "A + 1": None,
    "sphere { 0, 1 }": None,
    "1/0": None,
}


@pytest.mark.parametrize(("value", "expected"), VALUES.items())
def test_values(value: str, expected: str | None) -> None:
    document = Document(f"#declare B = 3;\n#declare C = <1, 2, 3>;\n#declare A = {value};\n", "a.pov")
    found = value_of(Library(()), document, globals_of(document)["A"])
    assert (found if found is None else shown(found)) == expected


def test_blocks_accept_what_their_constructs_say() -> None:
    assert "phong_size" in accepted(("sphere", "finish"))
    assert "phong_size" not in accepted(("sphere",))
    assert "strength" in accepted(("blob", "sphere"))
    assert "strength" not in accepted(("sphere",))
    assert "box" in accepted(("union",))
    assert "phong" in accepted(("texture", "texture_map", "[", "finish"))
    assert {"sphere", "isosurface", "lathe"} <= OBJECTS
    assert {"camera", "light_source", "global_settings", "fog"} <= SCENE
    assert not {"pigment", "finish", "color_map", "warp"} & SCENE


def test_the_library_reads_a_changed_include_again(tmp_path: Path) -> None:
    (tmp_path / "a.inc").write_text("#declare One = 1;")
    library = Library(())
    document = library.put(str(tmp_path / "s.pov"), '#include "a"\nsphere { 0, Two }\n')
    assert [one.message for one in problems(document, library)] == ["unknown name 'Two'"]
    (tmp_path / "a.inc").write_text("#declare One = 1; #declare Two = 2;")
    assert problems(document, library) == []
    edited = library.put(str(tmp_path / "a.inc"), "#declare Three = 3;")
    assert "Three" in globals_of(edited)
    assert [one.message for one in problems(document, library)] == ["unknown name 'Two'"]


def test_a_run_of_vectors_in_a_block_that_is_not_closed() -> None:
    text = "mesh2 { vertex_vectors { 40,\n" + "<1, 2, 3>,\n" * 40 + "sphere { 0, 1 }\n"
    (found,) = syntax_problems(Document(text))
    assert "never closed" in found.message
