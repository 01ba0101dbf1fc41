"""Write scenes/README.md and docs/features.md from the headers of the scenes: python tests/tools/catalogue.py."""

import sys
from pathlib import Path

import features_page

SCENES = Path(__file__).resolve().parents[2] / "scenes"

INTRODUCTION = """# Scenes

Our own scenes, each small. A scene opens with comment lines that tools read:

    // one line that says what it shows
    // class: exact              or: close — reason
    // switches: +A0.3 +AM2      render switches, where they matter

`features/` holds one scene per feature of the language; the parity tests render each with minipov and with POV-Ray and
assert its class. `features/later/` holds scenes of features that are not asserted yet. Images are beside them in
`features/images/`; POV-Ray finds them with `+L` and the folder of the scene. `gallery/` is for looking at.

This page is made by `python tests/tools/catalogue.py`.
"""


def entry(path: Path) -> str:
    """The catalogue line of one scene: name, description, and its class where it is not exact."""
    lines = path.read_text(encoding="utf-8").splitlines()
    description = lines[0].removeprefix("// ")
    kind = next((line.removeprefix("// class: ") for line in lines[1:3] if line.startswith("// class: ")), "exact")
    remark = "" if kind == "exact" else f" ({kind})"
    return f"| [{path.stem}]({path.relative_to(SCENES).as_posix()}) | {description}{remark} |"


def catalogue() -> str:
    """The whole page."""
    folders = {
        "Gallery": "gallery",
        "Features": "features",
        "Features not asserted yet": "features/later",
    }
    parts = [INTRODUCTION]
    for title, folder in folders.items():
        files = sorted((SCENES / folder).glob("*.pov"))
        parts.append(f"\n## {title} ({len(files)})\n\n| scene | shows |\n|---|---|\n")
        parts.append("".join(entry(path) + "\n" for path in files))
    return "".join(parts)


def main() -> int:
    (SCENES / "README.md").write_text(catalogue(), encoding="utf-8")
    features_page.PAGE.write_text(features_page.page(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
