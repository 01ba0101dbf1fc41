"""Write docs/features.md: python tests/tools/catalogue.py. The classes come from the headers of the scenes."""

from __future__ import annotations

from pathlib import Path

from feature_table import FEATURES, Row

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/features.md"
SCENES = ROOT / "scenes/features"

INTRODUCTION = """# Features

What of POV-Ray's scene description language minipov renders, and how well. Each feature has scenes that show it; the
parity tests render them with minipov and with POV-Ray 3.7, and assert the class that the scene names.

| class | meaning |
|---|---|
| exact | at least 99 % of the pixels within 2/255, FLIP at most 0.01; language: both programs print the same |
| close | FLIP at most 0.05: right but for the noise of sampling |
| tested | our own tests say so; there is nothing to compare with |
| not yet | left out with a warning, or not yet as close as that |
| no test | nothing shows it yet |

Where a row names several scenes, the class is that of the worst. This page is made by
`python tests/tools/catalogue.py`.
"""


def page() -> str:
    """The whole page."""
    parts = [INTRODUCTION]
    for section, rows in FEATURES.items():
        parts.append(f"\n## {section}\n\n| feature | class | shown by |\n|---|---|---|\n")
        parts += [f"| {row[0]} | {feature_class(row)} | {', '.join(map(_link, evidence(row)))} |\n" for row in rows]
    rest = [path for path in sorted(SCENES.glob("**/*.pov")) if path not in _shown()]
    if rest:
        parts.append("\n## Further scenes\n\n| what it shows | class | scene |\n|---|---|---|\n")
        parts += [f"| {_title(path)} | {evidence_class(path)} | {_link(path)} |\n" for path in rest]
    return "".join(parts)


def _shown() -> set[Path]:
    return {path for rows in FEATURES.values() for row in rows for path in evidence(row)}


def _title(scene: Path) -> str:
    return scene.read_text("utf-8").splitlines()[0].removeprefix("// ").replace("|", "\\|")


def evidence(row: Row) -> list[Path]:
    """The scenes and tests that show a feature: those asserted first."""
    found: list[Path] = []
    for pattern in row[1].split():
        if "/" in pattern:
            path = ROOT / pattern
            assert path.exists(), f"{pattern} of {row[0]} is not there"
            found.append(path)
        else:
            found += [path for folder in (SCENES, SCENES / "later") for path in sorted(folder.glob(f"{pattern}.pov"))]
    return list(dict.fromkeys(found))


def feature_class(row: Row) -> str:
    """The class of a feature: that of its worst scene."""
    order = ["exact", "tested", "close", "not yet"]
    return max((evidence_class(path) for path in evidence(row)), key=order.index, default="no test")


def evidence_class(path: Path) -> str:
    """What one scene or test says."""
    if path.parent == SCENES / "later":
        return "not yet"
    if path.suffix == ".pov":
        header = path.read_text("utf-8").splitlines()[1]
        return header.removeprefix("// class: ").split()[0]
    return "exact" if path.parent.name == "language" else "tested"


def _link(path: Path) -> str:
    return f"[{path.stem}](../{path.relative_to(ROOT).as_posix()})"
