"""The page of `minipov diff FOLDER`, opened in Chromium: rows, pictures, sorting."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from PIL import Image
from running import WHITE, fake_povray, minipov, said

MAGENTA = (255, 0, 255)


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A survey of three scenes, of which POV-Ray's pictures are magenta."""
    folder = tmp_path_factory.mktemp("survey")
    scenes = folder / "scenes"
    scenes.mkdir()
    (scenes / "bad.pov").write_text("// Fails & is <escaped>\nsphere { 0 }")
    (scenes / "equal.pov").write_text("// The same\n" + WHITE.replace("rgb 1", "rgb <1, 0, 1>"))
    (scenes / "white.pov").write_text("// Too white\n" + WHITE)
    run = minipov("diff", "scenes", "--page", "page", cwd=folder, env=fake_povray(folder, MAGENTA))
    assert run.returncode == 2, said(run)
    return folder / "page/index.html"


def chromium(page: Path, profile: Path, *switches: str, fragment: str = "") -> str:
    """Open the page and return its document as the browser has it after running scripts."""
    program = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    assert program is not None, "tools/install-chromium installs it"
    options = ("--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking", "--no-first-run")
    command = [program, *options, f"--user-data-dir={profile}", *switches, f"{page.as_uri()}{fragment}"]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, check=True).stdout


def names(document: str) -> list[str]:
    """The scenes' names in the order of their rows."""
    return re.findall(r"<tr [^>]*><td[^>]*><b>(.*?)</b>", document)


def test_each_scene_has_a_row(page: Path, tmp_path: Path) -> None:
    document = chromium(page, tmp_path, "--dump-dom")
    assert names(document) == ["bad", "equal", "white"]
    assert "Fails &amp; is &lt;escaped&gt;" in document
    assert "1 exact, 1 off, 1 failed" in document
    assert "bad.pov:2:12: error:" in document
    heads = re.findall(r"<th(?: [^>]*)?>(.*?)</th>", document)
    assert heads[:9] == ["scene", "class", "minipov", "POV-Ray", "difference", "within2", "FLIP", "mean error", "SSIM"]


@pytest.mark.parametrize(
    ("fragment", "order"),
    [
        ("#sort=FLIP,down", ["white", "equal", "bad"]),
        ("#sort=within2", ["white", "equal", "bad"]),
        ("#sort=class", ["equal", "white", "bad"]),
        ("#sort=scene,down", ["white", "equal", "bad"]),
    ],
)
def test_sorting(page: Path, tmp_path: Path, fragment: str, order: list[str]) -> None:
    assert names(chromium(page, tmp_path, "--dump-dom", fragment=fragment)) == order


def test_the_pictures_are_shown(page: Path, tmp_path: Path) -> None:
    shot = tmp_path / "shot.png"
    chromium(page, tmp_path / "profile", f"--screenshot={shot}", "--window-size=1600,900")
    colors = dict((color, count) for count, color in Image.open(shot).convert("RGB").getcolors(1 << 24) or [])
    thumbnail = 160 * 120
    # Twice beside each other in the row of the equal scene, once as the reference of the white and of the bad one.
    assert colors[MAGENTA] == pytest.approx(4 * thumbnail, rel=0.02)
    assert colors[0, 0, 0] == pytest.approx(thumbnail, rel=0.2)
