"""`minipov check`: several mistakes per run, worded as `file:line:col: message` with the line and a caret."""

import json
from pathlib import Path

from running import WHITE, minipov, said

OK, MISTAKES, USAGE = 0, 1, 2

BROKEN = """sphere { <0, 0, 1 }
box { 0, 1 }
#declare = 5;
sphere { 0, 1 }
box { <0, 0, 1, 2 }
"""


def test_a_good_scene(tmp_path: Path) -> None:
    (tmp_path / "good.pov").write_text(WHITE)
    run = minipov("check", "good.pov", cwd=tmp_path)
    assert (run.returncode, run.stdout, run.stderr) == (OK, b"", b"")


def test_all_mistakes_of_the_grammar(tmp_path: Path) -> None:
    (tmp_path / "broken.pov").write_text(BROKEN)
    run = minipov("check", "broken.pov", cwd=tmp_path)
    assert run.returncode == MISTAKES
    lines = run.stdout.decode().splitlines()
    heads = [line for line in lines if line.startswith("broken.pov:")]
    assert [line.split(":")[1] for line in heads] == ["1", "3", "5"]
    assert heads[0] == "broken.pov:1:19: error: unexpected '}', expected '>'"
    assert lines[1:3] == ["  sphere { <0, 0, 1 }", "                    ^"]


def test_a_mistake_at_run_time_and_what_follows(tmp_path: Path) -> None:
    (tmp_path / "wrong.pov").write_text('#warning "mind"\n#declare Size = 2;\nbox { 0, Sise }\nsphere { 0, Radus }\n')
    run = minipov("check", "wrong.pov", "--json", cwd=tmp_path)
    assert run.returncode == MISTAKES, said(run)
    found = [(entry["severity"], entry["line"], entry["column"]) for entry in json.loads(run.stdout)]
    assert found == [("warning", 1, 1), ("error", 3, 10), ("error", 4, 13)]
    assert "Size" in json.loads(run.stdout)[1]["hint"]


def test_going_on_after_mistakes_at_run_time(tmp_path: Path) -> None:
    scene = """#version 3.7;
#declare Far = sqrt(-4);
union { sphere { 0, Far } sphere { 0, "one" } }
sphere { 0, Far }
#macro Ball(R) sphere { R, Colour } #end
#for (I, 1, 3) Ball(I) #end
sphere { Colour, 1 }
box { 0, <1, 2, 3, 4> }
#error "enough"
box { 0, <1, 2, 3, 4> }
"""
    (tmp_path / "wrong.pov").write_text(scene)
    run = minipov("check", "wrong.pov", "--json", cwd=tmp_path)
    assert run.returncode == MISTAKES, said(run)
    found = [(entry["line"], entry["message"]) for entry in json.loads(run.stdout) if entry["severity"] == "error"]
    assert [line for line, _ in found] == [2, 5, 8, 9]
    assert found[1][1] == "'Colour' is not declared"


def test_a_mistake_in_a_macro_names_the_call(tmp_path: Path) -> None:
    (tmp_path / "macro.pov").write_text("#version 3.7;\n#macro Ball(R)\n  sphere { 0, Q }\n#end\nBall(1)\n")
    run = minipov("check", "macro.pov", "--json", cwd=tmp_path)
    (found,) = json.loads(run.stdout)
    assert found["line"] == 3
    assert ["macro.pov", 5, 1] in [place for _, place in found["stack"]]


def test_warnings_alone_are_no_mistakes(tmp_path: Path) -> None:
    (tmp_path / "warned.pov").write_text('#warning "mind"\n' + WHITE)
    run = minipov("check", "warned.pov", cwd=tmp_path)
    assert run.returncode == OK
    assert run.stdout.decode().splitlines()[0] == "warned.pov:1:1: warning: mind"


def test_options_and_several_scenes(tmp_path: Path) -> None:
    (tmp_path / "library").mkdir()
    (tmp_path / "library/part.inc").write_text("#declare Part = Given;")
    (tmp_path / "one.pov").write_text('#include "part.inc"\nbackground { rgb Part }\n' + WHITE)
    (tmp_path / "two.pov").write_text("sphere {")
    run = minipov("check", "one.pov", "two.pov", "+Llibrary", "Declare=Given=1", cwd=tmp_path)
    assert run.returncode == MISTAKES
    assert run.stdout.decode().count("error:") == 1
    assert "two.pov:1:1: error:" in run.stdout.decode()


def test_nothing_is_rendered_nor_written(tmp_path: Path) -> None:
    (tmp_path / "good.pov").write_text(WHITE)
    minipov("check", "good.pov", cwd=tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["good.pov"]


def test_usage(tmp_path: Path) -> None:
    assert minipov("check", cwd=tmp_path).returncode == USAGE
    run = minipov("check", "none.pov", cwd=tmp_path)
    assert run.returncode == MISTAKES
    assert "none.pov: error: cannot be read" in run.stdout.decode()
