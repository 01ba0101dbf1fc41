"""Whatever a scene says, it loads or ends in an `SdlError`: no traceback, no crash, no endless wait."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings, strategies as st
from minipov.interpreter import Options, SdlError, load_text

SCENES = (
    "sphere { <0, 0, 0>, 1 texture { pigment { rgb <1, 0.5, 0> } finish { phong 0.5 } } translate x*2 }",
    "#macro M(A, B) #local C = A + B; C*2 #end box { 0, M(1, 2) pigment { checker rgb 1, rgb 0 scale 0.5 } }",
    "#declare A = array[3] { 1, 2, 3 }; #for (I, 0, 2) cylinder { 0, A[I]*y, 0.1 } #end",
    "#declare F = function(a, b) { sin(a)*b } #declare S = spline { 0, x, 1, y } torus { F(1, 2), S(0.5).x }",
    "union { #if (1 < 2) sphere { 0, 1 } #else box { 0, 1 } #end difference { cone { 0, 1, y, 0 } plane { y, 0.5 } } }",
    '#declare T = concat("a", str(1.5, 0, 2)); #debug T text { internal 1 T 0.1, 0 } #switch (1) #case (1) #break #end',
    "light_source { <1, 2, 3>, rgb 1 spotlight radius 10 falloff 20 point_at 0 area_light x, y, 3, 3 jitter }",
    "camera { location -5*z look_at 0 angle 40 right x*4/3 } global_settings { assumed_gamma 1 max_trace_level 5 }",
    "mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 2> } pigment { gradient x } }",
    "isosurface { function { x*x + y*y - z } contained_by { box { -1, 1 } } max_gradient 3 } media { absorption 0.1 }",
    "blob { threshold 0.5 sphere { 0, 1, 1 } cylinder { 0, x, 0.5, 1 } } lathe { 2, <0,0>, <1,0> }",
    '#fopen H "robust.txt" write #write (H, 1, ",", <1,2,3>) #fclose H #version 3.7; #default { finish { ambient 0 } }',
)
TOKEN = re.compile(r'"[^"]*"|#\w+|[A-Za-z_]\w*|\d+\.?\d*|\S')
TOKENS = tuple(sorted({token for scene in SCENES for token in TOKEN.findall(scene)}))


@st.composite
def mutated(draw: st.DrawFn) -> str:
    """A scene with a few tokens left out, doubled, exchanged or put in."""
    tokens = TOKEN.findall(draw(st.sampled_from(SCENES)))
    for _ in range(draw(st.integers(1, 4))):
        at = draw(st.integers(0, len(tokens)))
        change = draw(st.sampled_from(("drop", "insert", "replace", "swap")))
        new: Sequence[str] = () if change == "drop" else (draw(st.sampled_from(TOKENS)),)
        if change == "swap" and at + 1 < len(tokens):
            new = (tokens[at + 1], tokens[at])
        tokens[at : at + (0 if change == "insert" else len(new) or 1)] = new
    return " ".join(tokens)


@given(mutated())
@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_mutated_scenes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, scene: str) -> None:
    monkeypatch.chdir(tmp_path)
    try:
        load_text(scene, options=Options(writable=(tmp_path,)))
    except SdlError as error:
        assert error.message


BOMBS = {
    "recursion": "#macro M(N) M(N + 1) #end M(1)",
    "recursion in an expression": "#macro M(N) (1 + M(N)) #end #declare A = M(1);",
    "two macros": "#macro A1() B1() #end #macro B1() A1() #end A1()",
    "giant array": "#declare A = array[100000][100000];",
    "deep parentheses": "#declare A = " + "(" * 20_000 + "1" + ")" * 20_000 + ";",
    "deep blocks": "union { " * 5_000 + "sphere { 0, 1 }" + "}" * 5_000,
    "deep ifs": "#if (1) " * 5_000 + "#end " * 5_000,
    "deep vectors": "#declare A = " + "<1, " * 3_000 + "1" + ">" * 3_000 + ";",
    "long sum": "#declare A = " + "1 + " * 20_000 + "1;",
    "huge number": "#declare A = 1e400; sphere { 0, A }",
    "not a number": "#declare A = 1e308*1e308 - 1e308*1e308; sphere { A, A } box { A, int(A) }",
    "include of itself": '#include "robust.pov"',
}


@pytest.mark.parametrize("name", BOMBS)
def test_bombs(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    options = Options(files={"robust.pov": BOMBS["include of itself"].encode()})
    try:
        load_text(BOMBS[name], "robust.pov", options)
    except SdlError as error:
        assert error.message


def test_an_endless_loop_can_be_interrupted(tmp_path: Path) -> None:
    scene = tmp_path / "endless.pov"
    scene.write_text("#declare A = 0; #while (1) #declare A = A + 1; #end")
    process = subprocess.Popen([sys.executable, "-m", "minipov", str(scene)], cwd=tmp_path, stderr=subprocess.PIPE)
    try:
        time.sleep(2)
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=10) == 130
    finally:
        process.kill()
        process.communicate()


NEST = "#declare I = 0; #while (I < 4000) {} #declare I = I + 1; #end"
UNENDING = {
    "objects": ("#declare O = sphere { 0, 1 }" + NEST.format("#declare O = union { object { O } sphere { x, 1 } }") * 2
                + "#declare E = min_extent(O);", "nested too deeply"),
    "functions": ("#declare F = function { x }" + NEST.format(
        "#declare G = function { F(x, y, z) + 1 } #undef F #declare F = function { G(x, y, z) } #undef G")
        + "#declare A = F(1, 2, 3);", "nested too deeply"),
    "sum": ("#declare F = function { sum(i, 0, 1e300, x) }", "would never end"),
    "product": ("#declare F = function { prod(i, 0, 1e10, x) }", "would never end"),
}  # fmt: skip


@pytest.mark.parametrize("name", UNENDING)
def test_what_would_never_end(name: str) -> None:
    scene, message = UNENDING[name]
    with pytest.raises(SdlError, match=message):
        load_text(scene)
