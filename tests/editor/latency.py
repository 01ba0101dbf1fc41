"""How long the answers take after an edit: `python tests/editor/latency.py [count]` on POV-Ray's largest files.

Each file is opened, then a declaration is typed in the middle, character by character; the table shows the slowest
answer of each kind in milliseconds of processor time.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

from corpus import FILES, library
from minipov.editor.analysis.checks import problems
from minipov.editor.analysis.colors import color_literals
from minipov.editor.analysis.completion import completions
from minipov.editor.analysis.document import Document
from minipov.editor.analysis.help import help_at
from minipov.editor.analysis.highlighting import highlights
from minipov.editor.analysis.library import Library
from minipov.editor.analysis.outline import folds, outline

TYPED = "\n#declare Q = 1;"


def answers(document: Document, texts: Library, offset: int) -> dict[str, Callable[[], object]]:
    """The questions that an editor asks after each key."""
    return {
        "complete": lambda: completions(document, texts, offset),
        "check": lambda: problems(document, texts),
        "hover": lambda: help_at(document, texts, offset - 2),
        "tokens": lambda: list(highlights(document, texts)),
        "outline": lambda: outline(document),
        "folds": lambda: folds(document),
        "colours": lambda: list(color_literals(document)),
    }


def measured(file: Path) -> Iterator[tuple[str, float]]:
    """Seconds for each step, by name."""
    texts = library()
    started = time.process_time()
    document = texts.get(str(file))
    assert document is not None
    problems(document, texts)
    yield "open", time.process_time() - started
    text = document.text
    at = text.find("\n", len(text) // 2)
    for length in range(1, len(TYPED) + 1):
        started = time.process_time()
        document = texts.put(str(file), text[:at] + TYPED[:length] + text[at:])
        yield "edit", time.process_time() - started
        for name, answer in answers(document, texts, at + length).items():
            started = time.process_time()
            answer()
            yield name, time.process_time() - started


def main() -> None:
    """Print the table."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 10
    header = True
    for file in sorted(FILES, key=lambda f: -f.stat().st_size)[:count]:
        slowest: dict[str, float] = {}
        for name, seconds in measured(file):
            slowest[name] = max(slowest.get(name, 0.0), seconds)
        if header:
            print(f"{'file':<18}{'KB':>6}", *(f"{name:>9}" for name in slowest))
            header = False
        size = file.stat().st_size // 1000
        print(f"{file.name:<18}{size:>6}", *(f"{1000 * seconds:>9.0f}" for seconds in slowest.values()), flush=True)


if __name__ == "__main__":
    main()
