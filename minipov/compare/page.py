"""The HTML page of a survey: both pictures, their difference, class, metrics and times of each scene; sortable."""

from __future__ import annotations

import html
import shutil
from collections.abc import Sequence
from importlib import resources
from pathlib import Path

from minipov.compare.difference import write_difference
from minipov.compare.rendering import Rendering
from minipov.compare.survey import Comparison
from minipov.compare.table import totals

_COLUMNS = ("scene", "class", "minipov", "POV-Ray", "difference", "within2", "FLIP", "SSIM", "trace s", "POV-Ray s", "")


def write_page(comparisons: Sequence[Comparison], folder: Path, title: str) -> Path:
    """Write ``folder``/index.html with the pictures beside it and return its path."""
    pictures = folder / "pictures"
    pictures.mkdir(parents=True, exist_ok=True)
    template = resources.files("minipov.compare").joinpath("page.html").read_text("utf-8")
    heads = "".join(f'<th data-column="{number}">{name}</th>' for number, name in enumerate(_COLUMNS))
    fields = {
        "TITLE": html.escape(title),
        "TOTALS": html.escape(", ".join(f"{count} {verdict}" for verdict, count in totals(comparisons).items())),
        "HEADS": heads,
        "ROWS": "\n".join(_row(comparison, pictures) for comparison in comparisons),
    }
    for name, text in fields.items():
        template = template.replace(f"@{name}@", text)
    page = folder / "index.html"
    page.write_text(template, "utf-8")
    return page


def _row(comparison: Comparison, pictures: Path) -> str:
    stem = comparison.name.replace("/", "_")
    ours = _picture(comparison.ours, pictures / f"{stem}-minipov.png")
    reference = _picture(comparison.reference, pictures / f"{stem}-povray.png")
    difference = pictures / f"{stem}-difference.png"
    written = ours is not None and reference is not None and write_difference(ours, reference, difference)
    metrics = comparison.metrics
    measures = (
        ["", "", ""] if metrics is None else [f"{metrics.within2:.4f}", f"{metrics.flip:.4f}", f"{metrics.ssim:.4f}"]
    )
    cells = [
        f"<b>{html.escape(comparison.name)}</b><br>{html.escape(comparison.title)}",
        comparison.verdict,
        _image(ours),
        _image(reference),
        _image(difference if written else None),
        *([f"{measure:.4f}" for measure in measures] or [""] * 3),
        _seconds(comparison.ours),
        _seconds(comparison.reference),
        f'<span class="message">{html.escape(comparison.message)}</span>',
    ]
    return (
        f'<tr class="{comparison.verdict.replace(" ", "-")}">' + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>"
    )


def _picture(made: Rendering | None, target: Path) -> Path | None:
    """Put a program's picture beside the page."""
    if made is None or made.picture is None or not made.picture.is_file():
        return None
    if made.picture.resolve() != target.resolve():
        shutil.copyfile(made.picture, target)
    return target


def _image(path: Path | None) -> str:
    return "" if path is None else f'<img loading="lazy" src="pictures/{html.escape(path.name, quote=True)}" alt="">'


def _seconds(made: Rendering | None) -> str:
    return "" if made is None or made.trace_seconds is None else f"{made.trace_seconds:.3f}"
