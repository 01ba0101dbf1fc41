"""`minipov scene.pov` as a user, or a program that expects POV-Ray, runs it."""

import os
import pty
import re
import signal
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from running import MINIPOV, SMALL, WHITE, environment, minipov, said

OK, SCENE_ERROR, USAGE_ERROR, INTERRUPTED = 0, 1, 2, 130

SLOW = """#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 200 adc_bailout 0 }
camera { location <0, 0, -3> look_at 0 }
light_source { <3, 5, -5> 1 area_light 4*x, 4*y, 60, 60 }
background { rgb 0.5 }
#for (I, 0, 40)
  sphere { <mod(I, 7) - 3, int(I / 7) - 3, I / 20>, 0.6 pigment { rgb 1 } finish { reflection 0.95 } }
#end
"""
"""Takes far longer to render than any test waits."""

MEDIUM = SLOW.replace("60, 60", "12, 12")
"""Takes some seconds."""

BEGUN = rb"Rendered [1-9]"
"""What a verbose run says when some pixels are finished."""


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    path = tmp_path / "scene.pov"
    path.write_text(WHITE)
    return path


def test_a_picture_is_written_beside_the_scene(scene: Path) -> None:
    run = minipov(scene.name, *SMALL, cwd=scene.parent)
    assert (run.returncode, run.stdout, run.stderr) == (OK, b"", b"")
    picture = Image.open(scene.with_suffix(".png"))
    assert (picture.size, picture.mode, picture.getpixel((3, 3))) == ((16, 12), "RGB", (255, 255, 255))


def test_long_options(scene: Path) -> None:
    run = minipov(scene.name, "-o", "out.png", "-W", "20", "-H", "10", "-t", "1", cwd=scene.parent)
    assert run.returncode == OK, said(run)
    assert Image.open(scene.parent / "out.png").size == (20, 10)


def test_an_ini_file_as_the_argument(scene: Path) -> None:
    """As ASE writes one, with floats for the size."""
    (scene.parent / "scene.ini").write_text(
        "Input_File_Name=scene.pov\nOutput_to_File=True\nOutput_File_Type=N\nOutput_Alpha=on\n; if you adjust Height\n"
        "Width=16.0\nHeight=12.48\nAntialias=True\nAntialias_Threshold=0.1\nDisplay=False\nDisplay_Gamma=2.2\n"
        "Pause_When_Done=False\nVerbose=False\n"
    )
    run = minipov("scene.ini", cwd=scene.parent)
    assert run.returncode == OK, said(run)
    assert Image.open(scene.with_suffix(".png")).size == (16, 12)
    assert Image.open(scene.with_suffix(".png")).mode == "RGBA"


@pytest.mark.parametrize(
    ("switch", "name", "kind", "mode"),
    [
        ("+FN", "scene.png", "PNG", "RGB"),
        ("+FT", "scene.tga", "TGA", "RGB"),
        ("+FC", "scene.tga", "TGA", "RGB"),
        ("+FP", "scene.ppm", "PPM", "RGB"),
        ("+FB", "scene.bmp", "BMP", "RGB"),
        ("+FJ", "scene.jpg", "JPEG", "RGB"),
        ("+FNg", "scene.png", "PNG", "I;16"),
    ],
)
def test_file_types(scene: Path, switch: str, name: str, kind: str, mode: str) -> None:
    run = minipov(scene.name, *SMALL, switch, cwd=scene.parent)
    assert run.returncode == OK, said(run)
    picture = Image.open(scene.parent / name)
    assert (picture.format, picture.mode, picture.size) == (kind, mode, (16, 12))


def test_sixteen_bits(scene: Path) -> None:
    scene.write_text(WHITE.replace("rgb 1", "rgb 0.2"))
    assert minipov(scene.name, *SMALL, "+FN16", "File_Gamma=1", cwd=scene.parent).returncode == OK
    header = scene.with_suffix(".png").read_bytes()
    assert header[24] == 16
    assert Image.open(scene.with_suffix(".png")).getpixel((0, 0)) == (51, 51, 51)


def test_ppm_to_standard_output(scene: Path) -> None:
    run = minipov(scene.name, *SMALL, "+FP", "+O-", cwd=scene.parent)
    assert run.returncode == OK, said(run)
    assert run.stdout == b"P6\n16 12\n255\n" + b"\xff" * (16 * 12 * 3)


def test_a_scene_from_standard_input(tmp_path: Path) -> None:
    run = minipov("-", *SMALL, "-o", "out.png", cwd=tmp_path, stdin=WHITE.encode())
    assert run.returncode == OK, said(run)
    assert (tmp_path / "out.png").is_file()


def test_no_file(scene: Path) -> None:
    assert minipov(scene.name, *SMALL, "-F", cwd=scene.parent).returncode == OK
    assert not scene.with_suffix(".png").exists()


def test_part_of_a_picture(scene: Path) -> None:
    run = minipov(scene.name, *SMALL, "+SR4", "+ER6", "+SC0.5", cwd=scene.parent)
    assert run.returncode == OK, said(run)
    codes = np.asarray(Image.open(scene.with_suffix(".png")).convert("L"))
    rows, columns = np.nonzero(codes)
    assert (rows.min(), rows.max(), columns.min(), columns.max()) == (3, 5, 8, 15)


def test_an_animation(tmp_path: Path) -> None:
    (tmp_path / "an.pov").write_text(WHITE.replace("rgb 1", "rgb clock"))
    run = minipov("an.pov", *SMALL, "+KFF3", "File_Gamma=1", cwd=tmp_path)
    assert run.returncode == OK, said(run)
    greys = [Image.open(tmp_path / f"an{number}.png").convert("L").getpixel((0, 0)) for number in (1, 2, 3)]
    assert greys == [0, 128, 255]


def test_declared_values_and_headers(tmp_path: Path) -> None:
    (tmp_path / "header.inc").write_text("#declare Sum = Given + 1;")
    (tmp_path / "scene.pov").write_text('#debug concat("sum ", str(Sum, 0, 1), "\\n")\n' + WHITE)
    run = minipov("scene.pov", *SMALL, "Declare=Given=2.5", "+HIheader.inc", cwd=tmp_path)
    assert run.returncode == OK, said(run)
    assert "sum 3.5" in said(run)


def test_includes_are_found(tmp_path: Path) -> None:
    library, named = tmp_path / "library", tmp_path / "named"
    for folder in (library, named):
        folder.mkdir()
    (library / "one.inc").write_text("#declare One = 1;")
    (named / "two.inc").write_text("#declare Two = 2;")
    (tmp_path / "scene.pov").write_text(
        '#include "one.inc"\n#include "two.inc"\n#include "colors.inc"\n' + WHITE.replace("rgb 1", "White * One * Two")
    )
    run = minipov("scene.pov", *SMALL, f"+L{library}", cwd=tmp_path, env={"POVINC": str(named)})
    assert run.returncode == OK, said(run)


# --- what is said ---


def test_verbose_runs_say_what_programs_look_for(scene: Path) -> None:
    run = minipov(scene.name, *SMALL, "+V", cwd=scene.parent)
    lines = said(run).replace("\r", "\n").splitlines()
    assert "==== [Parsing...] ==========================================================" in lines
    assert "==== [Rendering...] ========================================================" in lines
    assert "Rendered 192 of 192 pixels (100%)" in lines


def test_a_pipe_stays_quiet_but_for_warnings(scene: Path) -> None:
    scene.write_text('#warning "careful"\n' + WHITE)
    run = minipov(scene.name, *SMALL, cwd=scene.parent)
    assert run.returncode == OK
    assert said(run) == "scene.pov:1:1: warning: careful\n"


def test_a_parse_error_is_worded_for_people_and_for_programs(tmp_path: Path) -> None:
    (tmp_path / "bad.pov").write_text("sphere { 0, 1 }\nbox { 0, 1, 2 }\n")
    run = minipov("bad.pov", *SMALL, cwd=tmp_path)
    assert run.returncode == SCENE_ERROR
    lines = said(run).splitlines()
    assert lines[0].startswith("bad.pov:2:")
    assert "  box { 0, 1, 2 }" in lines
    assert any(line.startswith("File 'bad.pov' line 2: Parse Error: ") for line in lines)
    assert "Fatal error in parser: Cannot parse input." in lines


def test_streams_go_to_files(scene: Path) -> None:
    scene.write_text('#debug "hello\\n"\n#warning "careful"\n' + WHITE)
    run = minipov(scene.name, *SMALL, "-GDdebug.txt", "+GWwarnings.txt", "+GAall.txt", cwd=scene.parent)
    assert run.returncode == OK
    assert "hello" not in said(run)
    assert "careful" in said(run)
    assert (scene.parent / "debug.txt").read_text().strip() == "hello"
    assert "careful" in (scene.parent / "warnings.txt").read_text()
    assert {"hello", "careful"} <= set((scene.parent / "all.txt").read_text().replace(":", " ").split())


def test_the_fatal_file(tmp_path: Path) -> None:
    (tmp_path / "bad.pov").write_text("sphere {")
    run = minipov("bad.pov", *SMALL, "Fatal_File=fatal.txt", cwd=tmp_path)
    assert run.returncode == SCENE_ERROR
    assert "File 'bad.pov' line 1: Parse Error" in (tmp_path / "fatal.txt").read_text()


def test_a_terminal_gets_a_progress_bar(tmp_path: Path) -> None:
    (tmp_path / "slow.pov").write_text(SLOW)
    leader, follower = pty.openpty()
    command = [*MINIPOV, "slow.pov", "+W160", "+H120"]
    with subprocess.Popen(command, cwd=tmp_path, env=environment({"TERM": "xterm"}), stderr=follower) as program:
        os.close(follower)
        shown = b""
        while b"/19200" not in shown:
            shown += os.read(leader, 4096)
        program.send_signal(signal.SIGINT)
        program.wait(10)
        os.close(leader)
    assert b"Rendering" in shown


# --- what goes wrong ---


@pytest.mark.parametrize(
    ("words", "status", "message"),
    [
        (["missing.pov"], SCENE_ERROR, "missing.pov"),
        (["folder"], USAGE_ERROR, "folder is a folder"),
        (["scene.pov", "+Onowhere/out.png"], SCENE_ERROR, "nowhere"),
        (["scene.pov", "+O/proc/out.png"], SCENE_ERROR, "/proc/out.png"),
        (["scene.pov", "+ZZ"], USAGE_ERROR, "+ZZ"),
        (["scene.pov", "+W0"], USAGE_ERROR, "0 by 12"),
        ([], USAGE_ERROR, ""),
    ],
)
def test_mistakes_end_with_a_message(scene: Path, words: list[str], status: int, message: str) -> None:
    (scene.parent / "folder").mkdir()
    run = minipov(*SMALL, *words, cwd=scene.parent) if words else minipov(cwd=scene.parent)
    assert run.returncode == status
    assert message in said(run)
    assert "Traceback" not in said(run)


def test_unknown_keys_are_only_warned_of(scene: Path) -> None:
    run = minipov(scene.name, *SMALL, "Quantity=9", cwd=scene.parent)
    assert run.returncode == OK
    assert "unknown option Quantity is ignored" in said(run)


def interrupted(scene: str, folder: Path, *words: str, after: bytes, times: int = 1) -> tuple[int, float, bytes]:
    """Press Ctrl-C, once or more, when a run has said ``after`` (a regular expression): its status, the seconds it took
    to end, and what it said then."""
    command = [*MINIPOV, scene, *words]
    with subprocess.Popen(command, cwd=folder, env=environment(), stderr=subprocess.PIPE) as program:
        assert program.stderr is not None
        heard = b""
        while not re.search(after, heard):
            more = os.read(program.stderr.fileno(), 4096)
            assert more, heard
            heard += more
        pressed = time.monotonic()
        for _ in range(times):
            program.send_signal(signal.SIGINT)
            time.sleep(0.002)
        _, errors = program.communicate(timeout=20)
        return program.returncode, time.monotonic() - pressed, errors


def test_ctrl_c_in_a_long_sum_while_parsing(tmp_path: Path) -> None:
    function = "#declare F = function (n) { sum(i, 0, n, sin(i)*cos(i)) }"
    (tmp_path / "long.pov").write_text(f'#debug "begun\\n"\n{function}\n#declare A = F(9e8);')
    status, seconds, _ = interrupted("long.pov", tmp_path, after=rb"begun\n")
    assert (status, seconds < 5) == (INTERRUPTED, True)


def test_ctrl_c_while_parsing(tmp_path: Path) -> None:
    (tmp_path / "endless.pov").write_text('#debug "begun\\n"\n#while (1) #declare A = 1; #end')
    tries = [interrupted("endless.pov", tmp_path, after=rb"begun\n") for _ in range(3)]
    assert {(status, errors) for status, _, errors in tries} == {(INTERRUPTED, b"error: interrupted\n")}
    # A busy machine may be late now and then.
    assert min(seconds for _, seconds, _ in tries) < 1


def test_ctrl_c_while_rendering_leaves_a_picture(tmp_path: Path) -> None:
    (tmp_path / "slow.pov").write_text(SLOW)
    tries = [interrupted("slow.pov", tmp_path, "+W640", "+H480", "+V", after=BEGUN) for _ in range(3)]
    assert {status for status, _, _ in tries} == {INTERRUPTED}
    assert all(errors.endswith(b"error: interrupted\n") for _, _, errors in tries)
    assert min(seconds for _, seconds, _ in tries) < 1
    picture = Image.open(tmp_path / "slow.png")
    picture.load()
    assert picture.size == (640, 480)


def test_an_interrupted_picture_is_gone_on_with(tmp_path: Path) -> None:
    (tmp_path / "scene.pov").write_text(MEDIUM)
    size = ("+W320", "+H240", "+WT1")
    status, _, _ = interrupted("scene.pov", tmp_path, *size, "+V", after=BEGUN)
    assert status == INTERRUPTED
    state = tmp_path / "scene.png.minipov-state"
    pixels = np.load(state)["pixels"]
    finished = ~np.isnan(pixels[..., 0])
    assert 0 < finished.mean() < 1
    # What is finished is believed: mark it, and find the mark in the picture.
    pixels[finished] = (0, 1, 0, 1)
    key = np.load(state)["key"]
    with state.open("wb") as file:
        np.savez(file, pixels=pixels, key=key)
    run = minipov("scene.pov", *size, "+C", cwd=tmp_path)
    assert run.returncode == OK, said(run)
    codes = np.asarray(Image.open(tmp_path / "scene.png").convert("RGB"))
    assert np.array_equal(np.all(codes == (0, 255, 0), axis=2), finished)
    assert not state.exists()


def test_other_options_begin_anew(tmp_path: Path) -> None:
    (tmp_path / "scene.pov").write_text(MEDIUM)
    assert interrupted("scene.pov", tmp_path, "+W320", "+H240", "+V", after=BEGUN)[0] == INTERRUPTED
    run = minipov("scene.pov", "+W32", "+H24", "+C", cwd=tmp_path)
    assert run.returncode == OK, said(run)
    assert np.all(np.asarray(Image.open(tmp_path / "scene.png").convert("L")) > 0)


# --- help and version ---


def test_help() -> None:
    for words in (["--help"], ["-help"], ["-?"], ["+H"]):
        run = minipov(*words, cwd=Path())
        assert run.returncode == OK
        assert run.stdout.startswith(b"usage: minipov SCENE.pov")


def test_version() -> None:
    run = minipov("--version", cwd=Path())
    assert run.returncode == OK
    assert run.stdout.startswith(b"minipov ")


def test_the_version_is_told_without_loading_the_libraries(tmp_path: Path) -> None:
    command = [MINIPOV[0], "-X", "importtime", *MINIPOV[1:], "--version"]
    run = subprocess.run(command, cwd=tmp_path, env=environment(), capture_output=True, text=True, check=True)
    for library in ("numpy", "OpenImageIO", "rich", "lark", "minipov.tracer"):
        assert f" {library}\n" not in run.stderr


def test_a_scene_that_is_known_needs_no_grammar(scene: Path) -> None:
    assert minipov(scene.name, *SMALL, cwd=scene.parent).returncode == OK
    command = [MINIPOV[0], "-X", "importtime", *MINIPOV[1:], scene.name, *SMALL]
    run = subprocess.run(command, cwd=scene.parent, env=environment(), capture_output=True, text=True, check=True)
    for library in ("rich", "lark", "PIL"):
        assert f" {library}\n" not in run.stderr


def test_ctrl_c_pressed_again_does_not_spoil_the_picture(tmp_path: Path) -> None:
    (tmp_path / "slow.pov").write_text(SLOW)
    status, _, errors = interrupted("slow.pov", tmp_path, "+W640", "+H480", "+V", after=BEGUN, times=20)
    assert (status, errors.splitlines()[-1]) == (INTERRUPTED, b"error: interrupted")
    assert b"Traceback" not in errors and b"panicked" not in errors
    Image.open(tmp_path / "slow.png").load()
