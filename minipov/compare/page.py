"""The HTML page of a survey: both pictures, their difference, class, metrics and times of each scene; sortable."""

from __future__ import annotations

import html
from collections.abc import Sequence
from importlib import resources
from pathlib import Path

from minipov.compare.rendering import Rendering
from minipov.compare.survey import DIFFERENCE, OURS, REFERENCE, Comparison, picture_name
from minipov.compare.table import totals
from minipov.compare.verdict import VERDICTS

_COLUMNS = (
    "scene", "class", "minipov", "POV-Ray", "difference", "within2", "FLIP", "mean error", "SSIM",
    "minipov trace s", "POV-Ray trace s", "minipov s", "POV-Ray s", "message",
)  # fmt: skip


def write_page(comparisons: Sequence[Comparison], folder: Path, title: str) -> Path:
    """Write ``folder``/index.html, which shows the pictures that the survey put into ``folder``/pictures."""
    folder.mkdir(parents=True, exist_ok=True)
    template = resources.files("minipov.compare").joinpath("page.html").read_text("utf-8")
    fields = {
        "TITLE": html.escape(title),
        "TOTALS": html.escape(", ".join(f"{count} {verdict}" for verdict, count in totals(comparisons).items())),
        "HEADS": "".join(f"<th>{name}</th>" for name in _COLUMNS),
        "ROWS": "\n".join(_row(comparison, folder / "pictures") for comparison in comparisons),
    }
    for name, text in fields.items():
        template = template.replace(f"@{name}@", text)
    page = folder / "index.html"
    page.write_text(template, "utf-8")
    return page


def _row(comparison: Comparison, pictures: Path) -> str:
    metrics = comparison.metrics
    numbers = ("", "", "", "")
    if metrics is not None:
        numbers = (
            f"{metrics.within2:.4f}",
            f"{metrics.flip:.4f}",
            f"{metrics.mean_error:.3f}",
            f"{metrics.ssim:.4f}",
        )
    cells = [
        _cell(f"<b>{html.escape(comparison.name)}</b><br>{html.escape(comparison.title)}", comparison.name),
        _cell(comparison.verdict, str(list(VERDICTS).index(comparison.verdict))),
        *(_image(pictures / picture_name(comparison.name, side)) for side in (OURS, REFERENCE, DIFFERENCE)),
        *(_cell(number) for number in numbers),
        *(_cell(_seconds(made, "trace_seconds")) for made in (comparison.ours, comparison.reference)),
        *(_cell(_seconds(made, "seconds")) for made in (comparison.ours, comparison.reference)),
        _cell(f'<span class="message">{html.escape(comparison.message)}</span>', html.escape(comparison.message)),
    ]
    return f'<tr class="{comparison.verdict.replace(" ", "-")}">{"".join(cells)}</tr>'


def _cell(content: str, key: str | None = None) -> str:
    """A cell; ``key`` is what its column is sorted by, the content where there is none."""
    return f'<td data-key="{html.escape(content if key is None else key, quote=True)}">{content}</td>'


def _image(path: Path) -> str:
    image = f'<img loading="lazy" src="pictures/{html.escape(path.name, quote=True)}" alt="">' if path.is_file() else ""
    return _cell(image, str(bool(image)))


def _seconds(made: Rendering | None, name: str) -> str:
    seconds = None if made is None else getattr(made, name)
    return "" if seconds is None else f"{seconds:.3f}"
