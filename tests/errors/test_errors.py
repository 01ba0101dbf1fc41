"""Every bad scene is refused, or warned of, with a place and in words; POV-Ray agrees that it is bad."""

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import povray_text
import pytest
from bad_scenes import BAD_SCENES, BadScene


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
