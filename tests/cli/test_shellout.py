"""Commands before and after scenes and frames, and what their exit statuses decide."""

from pathlib import Path

import pytest
from running import SMALL, WHITE, minipov, said

OK, SCENE_ERROR, USAGE_ERROR, INTERRUPTED = 0, 1, 2, 130


def run(folder: Path, *statements: str, frames: int = 3) -> tuple[int, list[str], list[str]]:
    """Render an animation: the exit status, what the commands wrote, and the pictures."""
    (folder / "an.pov").write_text(WHITE)
    ended = minipov("an.pov", *SMALL, f"+KFF{frames}", *statements, cwd=folder)
    log = folder / "log"
    said_by_commands = log.read_text().splitlines() if log.exists() else []
    assert "Traceback" not in said(ended)
    return ended.returncode, said_by_commands, sorted(path.name for path in folder.glob("*.png"))


def test_each_moment_has_its_command(tmp_path: Path) -> None:
    statements = [
        "Pre_Scene_Command=echo begin %s %wx%h >> log",
        "Pre_Frame_Command=echo before %n >> log",
        "Post_Frame_Command=echo after %n %o at %k 100%% >> log",
        "Post_Scene_Command=echo end >> log",
    ]
    status, log, pictures = run(tmp_path, *statements, frames=2)
    assert status == OK
    frames = ["before 1", "after 1 an1.png at 0 100%", "before 2", "after 2 an2.png at 1 100%"]
    assert log == ["begin an 16x12", *frames, "end"]
    assert pictures == ["an1.png", "an2.png"]


@pytest.mark.parametrize(
    ("statements", "status", "pictures"),
    [
        (["Pre_Frame_Command=exit 1"], OK, ["an1.png", "an2.png", "an3.png"]),
        (["Pre_Frame_Command=test %n != 2", "Pre_Frame_Return=S"], OK, ["an1.png", "an3.png"]),
        (["Pre_Frame_Command=test %n = 2", "Pre_Frame_Return=-S"], OK, ["an1.png", "an3.png"]),
        (["Post_Frame_Command=test %n != 2", "Post_Frame_Return=A"], OK, ["an1.png", "an2.png"]),
        (["Post_Frame_Command=exit 1", "Post_Frame_Return=Q"], OK, ["an1.png"]),
        (["Post_Frame_Command=exit 1", "Post_Frame_Return=F"], SCENE_ERROR, ["an1.png"]),
        (["Post_Frame_Command=exit 1", "Post_Frame_Return=U"], INTERRUPTED, ["an1.png"]),
        (["Pre_Scene_Command=exit 1", "Pre_Scene_Return=S"], OK, []),
        (["Pre_Scene_Command=exit 1", "Pre_Scene_Return=X"], USAGE_ERROR, []),
    ],
)
def test_what_follows(tmp_path: Path, statements: list[str], status: int, pictures: list[str]) -> None:
    ended, _, written = run(tmp_path, *statements)
    assert (ended, written) == (status, pictures)


def test_a_failed_scene_has_its_command_too(tmp_path: Path) -> None:
    (tmp_path / "bad.pov").write_text("sphere {")
    ended = minipov("bad.pov", *SMALL, "Fatal_Error_Command=echo failed %s > log", cwd=tmp_path)
    assert ended.returncode == SCENE_ERROR
    assert (tmp_path / "log").read_text() == "failed bad\n"
