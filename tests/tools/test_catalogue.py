"""scenes/README.md says what the scenes say."""

from catalogue import SCENES, catalogue


def test_the_catalogue_is_fresh() -> None:
    assert (SCENES / "README.md").read_text(encoding="utf-8") == catalogue(), "run python tests/tools/catalogue.py"


def test_every_scene_has_a_header() -> None:
    for scene in SCENES.glob("**/*.pov"):
        first, second = scene.read_text(encoding="utf-8").splitlines()[:2]
        assert first.startswith("// "), scene
        assert second == "// class: exact" or second.startswith("// class: close — "), scene
