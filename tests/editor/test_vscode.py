"""What the VS Code extension ships, as far as Python can tell; `make editor` runs its own tests."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from minipov.editor.analysis.document import Document
from minipov.editor.analysis.syntax import syntax_problems
from minipov.interpreter import SdlError, load_text

EXTENSION = Path(__file__).parents[2] / "editor/vscode"
PACKAGE = json.loads((EXTENSION / "package.json").read_text())
SNIPPETS = json.loads((EXTENSION / "snippets/povray.json").read_text())


def expanded(body: list[str]) -> str:
    """A snippet with its defaults filled in."""
    text = "\n".join(body)
    defaults = dict(re.findall(r"\$\{(\d+):([^}]*)\}", text))
    text = re.sub(r"\$\{(\d+):[^}]*\}", r"$\1", text)
    return re.sub(r"\$(\d+)", lambda match: defaults.get(match[1], ""), text)


@pytest.mark.parametrize("name", SNIPPETS)
def test_snippets_are_sdl(name: str) -> None:
    assert syntax_problems(Document(expanded(SNIPPETS[name]["body"]))) == []


def test_the_scene_snippet_is_a_scene() -> None:
    scene = load_text(expanded(SNIPPETS["Scene"]["body"]))
    assert (len(scene.objects), len(scene.lights)) == (2, 1)


def test_the_problem_matcher_reads_our_errors() -> None:
    (matcher,) = PACKAGE["contributes"]["problemMatchers"]
    pattern = matcher["pattern"]
    with pytest.raises(SdlError) as caught:
        load_text("sphere {\n 0, Radius }", "folder/a.pov")
    found = re.match(pattern["regexp"], str(caught.value))
    assert found is not None
    assert [found[pattern[part]] for part in ("file", "line", "column", "severity")] == [
        "folder/a.pov",
        "2",
        "5",
        "error",
    ]


def test_what_the_package_names_is_there() -> None:
    contributes = PACKAGE["contributes"]
    for part in (*contributes["grammars"], *contributes["snippets"]):
        assert (EXTENSION / part["path"]).is_file()
    source = (EXTENSION / "src/extension.ts").read_text()
    for command in contributes["commands"]:
        assert f'"{command["command"]}"' in source
    for setting in contributes["configuration"]["properties"]:
        assert f'"{setting.removeprefix("minipov.")}"' in source
