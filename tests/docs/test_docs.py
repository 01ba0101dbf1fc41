"""What the documents say is so: features and their classes, options, links."""

from __future__ import annotations

import re
from pathlib import Path

import features_page
import pytest
from command_line_page import PAGE as COMMAND_LINE, page as command_line_page
from feature_table import FEATURES

ROOT = Path(__file__).parents[2]
DOCUMENTS = [ROOT / "README.md", ROOT / "scenes/README.md", *sorted((ROOT / "docs").glob("*.md"))]
_ROW = re.compile(r"^\| (.+) \| (exact|close|tested|not yet|no test) \| (.*) \|$", re.MULTILINE)
_SCENE = re.compile(r"\(\.\./(scenes/features/(?:later/)?\w+\.pov)\)")


def test_the_page_of_features_is_fresh() -> None:
    assert features_page.PAGE.read_text("utf-8") == features_page.page(), "run python tests/tools/catalogue.py"


def test_every_feature_has_the_class_of_its_worst_scene() -> None:
    """Read from the page itself, not from the table that it is made of."""
    rows = _ROW.findall(features_page.PAGE.read_text("utf-8"))
    assert len(rows) > 120
    for feature, named, shown_by in rows:
        for scene in _SCENE.findall(shown_by):
            second = (ROOT / scene).read_text("utf-8").splitlines()[1]
            expected = "not yet" if "/later/" in scene else second.split()[2]
            assert named == expected or (named, expected) in {
                ("close", "exact"),
                ("not yet", "exact"),
                ("not yet", "close"),
                ("tested", "exact"),
            }, (feature, scene)


def test_what_a_feature_names_stands_in_its_scenes() -> None:
    """A row that claims a class has scenes that use the words it names."""
    claimed = {"exact", "close"}
    for row in (row for rows in FEATURES.values() for row in rows):
        if features_page.feature_class(row) in claimed:
            files = [
                file
                for path in features_page.evidence(row)
                for file in ([path] if path.is_file() else path.rglob("*.pov"))
            ]
            shown = "".join(file.read_text("utf-8", "replace") for file in files)
            words = [name.split()[0].lstrip("#").rstrip("…") for name in re.findall(r"`([^`]+)`", row[0])]
            assert [word for word in words if word not in shown] == [], row[0]


def test_every_scene_shows_a_feature() -> None:
    page = features_page.PAGE.read_text("utf-8")
    scenes = {path.relative_to(ROOT).as_posix() for path in features_page.SCENES.glob("**/*.pov")}
    assert scenes - set(_SCENE.findall(page)) == set()


def test_the_page_of_options_is_fresh() -> None:
    assert COMMAND_LINE.read_text("utf-8") == command_line_page(), "run python tests/tools/command_line_page.py"


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_links_lead_somewhere(document: Path) -> None:
    links = re.findall(r"\]\(([^)#]+)\)", document.read_text("utf-8"))
    missing = [link for link in links if "://" not in link and not (document.parent / link).exists()]
    assert missing == []
