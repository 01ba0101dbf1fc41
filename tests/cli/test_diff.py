"""`minipov diff`: exit statuses, what is printed, and that no scene ends a survey."""

import json
import multiprocessing
import os
import signal
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from running import WHITE, fake_povray, minipov, said

from minipov.compare.ours import run_minipov

WITHIN, BEYOND, MISSING = 0, 1, 2
WHITE_CODES, GREY_CODES = (255, 255, 255), (128, 128, 128)


def paint(path: Path, color: tuple[int, int, int], size: tuple[int, int] = (16, 12)) -> Path:
    Image.new("RGB", size, color).save(path)
    return path


def test_equal_pictures_are_within(tmp_path: Path) -> None:
    run = minipov("diff", paint(tmp_path / "a.png", GREY_CODES), paint(tmp_path / "b.png", GREY_CODES), cwd=tmp_path)
    assert run.returncode == WITHIN
    assert run.stdout.decode().startswith("exact: within2 1.0000, FLIP 0.0000, mean error 0.000, SSIM 1.0000")


def test_pictures_far_apart_are_beyond(tmp_path: Path) -> None:
    run = minipov("diff", paint(tmp_path / "a.png", GREY_CODES), paint(tmp_path / "b.png", WHITE_CODES), cwd=tmp_path)
    assert run.returncode == BEYOND
    assert run.stdout.decode().startswith("off: within2 0.0000")


def test_the_tolerance_decides(tmp_path: Path) -> None:
    noise = np.full((48, 64, 3), 128, np.uint8)
    noise[::7, ::7] += 6
    Image.fromarray(noise).save(tmp_path / "noisy.png")
    paint(tmp_path / "calm.png", GREY_CODES, (64, 48))
    assert minipov("diff", "noisy.png", "calm.png", cwd=tmp_path).returncode == WITHIN
    assert minipov("diff", "noisy.png", "calm.png", "--tolerance", "exact", cwd=tmp_path).returncode == BEYOND


def test_a_picture_that_is_not_there(tmp_path: Path) -> None:
    run = minipov("diff", paint(tmp_path / "a.png", GREY_CODES), "none.png", cwd=tmp_path)
    assert run.returncode == MISSING
    assert "none.png" in said(run)


def test_pictures_of_other_sizes(tmp_path: Path) -> None:
    run = minipov(
        "diff", paint(tmp_path / "a.png", GREY_CODES), paint(tmp_path / "b.png", GREY_CODES, (8, 8)), cwd=tmp_path
    )
    assert run.returncode == MISSING
    assert "different sizes: 16x12 and 8x8" in said(run)


def test_half_a_picture(tmp_path: Path) -> None:
    Image.effect_noise((64, 48), 50).save(tmp_path / "whole.png")
    (tmp_path / "half.png").write_bytes((tmp_path / "whole.png").read_bytes()[:900])
    run = minipov("diff", "whole.png", "half.png", cwd=tmp_path)
    assert run.returncode == MISSING
    assert "minipov diff: cannot read half.png" in said(run)


@pytest.mark.parametrize("kind", ["I;16", "LA", "RGBA", "P"])
def test_kinds_of_pictures(tmp_path: Path, kind: str) -> None:
    """16 bits, an alpha channel, and a palette make no difference where they say the same."""
    grey = Image.new("I;16", (16, 12), 128 * 257) if kind == "I;16" else Image.new("L", (16, 12), 128).convert(kind)
    grey.save(tmp_path / "kind.png")
    run = minipov("diff", "kind.png", paint(tmp_path / "plain.png", GREY_CODES), cwd=tmp_path)
    assert run.stdout.decode().startswith("exact: within2 1.0000, FLIP 0.0000, mean error 0.000"), said(run)


@pytest.mark.parametrize("paths", [["a.png"], ["a.png", "a.png", "a.png"], ["a.png", "scene.pov"]])
def test_pictures_come_in_pairs(tmp_path: Path, paths: list[str]) -> None:
    paint(tmp_path / "a.png", GREY_CODES)
    run = minipov("diff", *paths, cwd=tmp_path)
    assert run.returncode == MISSING
    assert "compare two pictures, or scenes and folders" in said(run)


def test_metrics_as_json(tmp_path: Path) -> None:
    run = minipov(
        "diff", paint(tmp_path / "a.png", (10, 20, 33)), paint(tmp_path / "b.png", (10, 20, 30)), "--json", cwd=tmp_path
    )
    outcome = json.loads(run.stdout)
    assert outcome["within2"] == 0.0
    assert outcome["mean_error"] == 1.0
    assert outcome["verdict"] == "close"
    assert 0 < outcome["flip"] < 0.05 < outcome["ssim"] <= 1


def test_a_scene_within(tmp_path: Path) -> None:
    (tmp_path / "white.pov").write_text(WHITE)
    run = minipov("diff", "white.pov", "--json", cwd=tmp_path, env=fake_povray(tmp_path, WHITE_CODES))
    assert run.returncode == WITHIN, said(run)
    (outcome,) = json.loads(run.stdout)
    assert (outcome["name"], outcome["verdict"]) == ("white", "exact")


def test_a_scene_beyond(tmp_path: Path) -> None:
    (tmp_path / "white.pov").write_text(WHITE)
    run = minipov("diff", "white.pov", cwd=tmp_path, env=fake_povray(tmp_path, GREY_CODES))
    assert run.returncode == BEYOND, said(run)


def test_a_scene_without_a_picture(tmp_path: Path) -> None:
    (tmp_path / "bad.pov").write_text("sphere { 0 }")
    run = minipov("diff", "bad.pov", cwd=tmp_path, env=fake_povray(tmp_path, GREY_CODES))
    assert run.returncode == MISSING
    assert "bad.pov:1:12: error:" in run.stdout.decode()


def test_without_povray(tmp_path: Path) -> None:
    (tmp_path / "white.pov").write_text(WHITE)
    run = minipov("diff", "white.pov", cwd=tmp_path, env={"POVRAY_BINARY": "/no/such/program"})
    assert run.returncode == MISSING
    assert "POV-Ray is needed" in said(run)
    assert "Traceback" not in said(run)


def test_no_scene_there(tmp_path: Path) -> None:
    run = minipov("diff", "nowhere", cwd=tmp_path, env=fake_povray(tmp_path, GREY_CODES))
    assert run.returncode == MISSING
    assert "no scene at nowhere" in said(run)


def test_a_folder_goes_on_after_a_hang_and_an_error(tmp_path: Path) -> None:
    scenes = tmp_path / "scenes"
    scenes.mkdir()
    (scenes / "a_hangs.pov").write_text("#while (1) #end")
    (scenes / "b_fails.pov").write_text("sphere { 0 }")
    (scenes / "c_refused.pov").write_text("// refuse\n" + WHITE)
    (scenes / "d_works.pov").write_text(WHITE)
    env = fake_povray(tmp_path, WHITE_CODES)
    # Long enough for three programs to start on two busy cores; only the first scene uses it up.
    run = minipov("diff", "scenes", "--timeout", "15", "--json", "--jobs", "2", cwd=tmp_path, env=env)
    verdicts = {outcome["name"]: outcome["verdict"] for outcome in json.loads(run.stdout)}
    assert verdicts == {"a_hangs": "failed", "b_fails": "failed", "c_refused": "no reference", "d_works": "exact"}
    assert run.returncode == MISSING
    assert (tmp_path / "out/diff/index.html").is_file()


def test_a_crash_is_an_outcome(tmp_path: Path) -> None:
    scene = tmp_path / "hangs.pov"
    scene.write_text("#while (1) #end")

    def kill() -> None:
        while not (pids := [process.pid for process in multiprocessing.active_children() if process.pid]):
            time.sleep(0.05)
        os.kill(pids[0], signal.SIGSEGV)

    threading.Thread(target=kill).start()
    made = run_minipov(scene, (), tmp_path, 30)
    assert made.status == "failed"
    assert made.message == f"killed by signal {signal.SIGSEGV.value}"


@pytest.mark.parametrize(
    "arguments",
    [
        ["diff"],
        ["diff", "a.png", "b.png", "--tolerance", "near"],
        ["diff", "a.pov", "--size", "160"],
        ["diff", "a.pov", "--size", "0x10"],
    ],
)
def test_usage(tmp_path: Path, arguments: list[str]) -> None:
    run = minipov(*arguments, cwd=tmp_path)
    assert run.returncode == MISSING
    assert "usage: minipov diff" in said(run)
