"""Each feature scene, rendered by minipov and by POV-Ray, is as close as its header says.

POV-Ray's pictures are kept in ~/.cache/minipov; where they are missing they are rendered, less than a second each.
"""

from pathlib import Path

import pytest

from minipov.compare.survey import Plan, compare_scene
from minipov.compare.verdict import is_within

SCENES = sorted((Path(__file__).parents[2] / "scenes/features").glob("*.pov"))
PLAN = Plan(width=160, height=120, timeout=120)


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.stem)
def test_scene(scene: Path) -> None:
    outcome = compare_scene(scene, scene.stem, PLAN)
    assert outcome.expected == "exact" or outcome.expected == "close"
    assert is_within(outcome.verdict, outcome.expected), f"{outcome.verdict}: {outcome.metrics} {outcome.message}"


def test_no_folder_went_missing() -> None:
    assert len(SCENES) >= 80
