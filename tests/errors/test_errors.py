"""Every bad scene is refused, or warned of, with a place and in words; POV-Ray agrees that it is bad."""

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import minipov_text
import povray_text
import pytest
from bad_scenes import BAD_SCENES, BadScene
from minipov.interpreter.errors import Place


@pytest.mark.parametrize("scene", BAD_SCENES, ids=lambda scene: scene.path.stem)
def test_minipov(scene: BadScene, tmp_path: Path) -> None:
    said = minipov_text.run_minipov(scene.path, tmp_path)
    if scene.kind == "error":
        assert said.error is not None, "accepted"
        assert place_of(said.error.place) == scene.place
        assert scene.part in said.error.message
        assert scene.hint in (said.error.hint or "")
    else:
        assert said.error is None, str(said.error)
        matching = [warning for warning in said.warnings if scene.part in warning.text]
        assert [place_of(warning.place) for warning in matching] == [scene.place]


def place_of(place: Place) -> str:
    """A place as the headers of bad scenes have it."""
    file, line, column = place
    return f"{Path(file).name}:{line}:{column}"


@pytest.mark.skipif(povray_text.PROGRAM is None, reason="POV-Ray is not installed")
def test_povray_agrees(tmp_path: Path) -> None:
    def outcome(scene: BadScene) -> tuple[str, str]:
        work = tmp_path / scene.path.stem
        work.mkdir()
        said = povray_text.run_povray(scene.path, work)
        warned = "Warning" in said.warnings or "Possible" in said.warnings
        return scene.path.stem, "error" if said.status else "warning" if warned else "nothing"

    with ThreadPoolExecutor(8) as pool:
        outcomes = dict(pool.map(outcome, BAD_SCENES))
    assert outcomes == {scene.path.stem: scene.kind for scene in BAD_SCENES}
