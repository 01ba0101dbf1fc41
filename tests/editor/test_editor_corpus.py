"""Every file that POV-Ray ships: opened, asked everything, and found free of mistakes."""

from __future__ import annotations

from itertools import pairwise

import pytest
from corpus import FILES, FOLDERS, REJECTED_BY_POVRAY, library
from minipov.editor.analysis.checks import problems
from minipov.editor.analysis.colors import color_literals, written
from minipov.editor.analysis.completion import completions
from minipov.editor.analysis.document import Document
from minipov.editor.analysis.help import help_at
from minipov.editor.analysis.highlighting import highlights
from minipov.editor.analysis.outline import folds, outline
from minipov.editor.analysis.parts import LARGE, problems_by_parts
from minipov.editor.analysis.recovery import parse
from minipov.editor.analysis.references import references_here
from minipov.editor.analysis.signatures import signature_at
from minipov.editor.analysis.syntax import tree_of
from minipov.grammar import parse as parse_file
from minipov.grammar.text import decode

LIBRARY = library()


def test_the_corpus_is_installed() -> None:
    assert len(FILES) > 400, "install povray-includes and povray-examples"


@pytest.mark.parametrize("folder", sorted({f.parent for f in FILES}), ids=lambda f: f.name)
def test_files_are_understood(folder: object) -> None:
    for file in (f for f in FILES if f.parent == folder):
        document = LIBRARY.get(str(file))
        assert document is not None
        assert "".join(statement.text for statement in document.statements) == document.text
        found = problems(document, LIBRARY)
        if file.name not in REJECTED_BY_POVRAY:
            assert [(document.line_of(one.start) + 1, one.message) for one in found] == [], file
        ask_everything(document)


def ask_everything(document: Document) -> None:
    """Every request once, and those about a position at a few of them."""
    lines = len(document.line_starts)
    assert all(0 <= first < last < lines for first, last, _ in folds(document))
    assert all(0 <= e.from_ <= e.start < e.end <= len(document.text) for e in outline(document))
    marked = list(highlights(document, LIBRARY))
    assert all(first[0] + first[1] <= second[0] for first, second in pairwise(marked))
    for literal in list(color_literals(document))[:5]:
        assert written(literal, document, literal.shown).startswith("<")
    for offset in range(0, len(document.text), max(1, len(document.text) // 4)):
        completions(document, LIBRARY, offset)
        help_at(document, LIBRARY, offset)
        signature_at(document, LIBRARY, offset)
    for offset, length, _, _ in marked[:: max(1, len(marked) // 3)]:
        found = references_here(document, document.text[offset : offset + length], offset)
        assert (offset, offset + length) in [(one.start, one.end) for one in found]


def test_statements_parse_as_the_whole_does() -> None:
    for file in FOLDERS[1].glob("*.inc"):
        text = decode(file.read_bytes())
        items = [item for statement in Document(text).statements for item in tree_of(statement)]
        assert [type(item) for item in items] == [type(item) for item in parse_file(text).items], file


@pytest.mark.parametrize("name", ["stones1.inc", "shapes3.inc", "woods.inc"])
def test_large_statements_in_parts_are_as_wrong_as_the_whole(name: str) -> None:
    text = decode((FOLDERS[1] / name).read_bytes())
    document = Document(text, name)
    assert max(len(statement.tokens) for statement in document.statements) >= LARGE
    for mistake in (")", "sphere", "= 1", "<"):
        for at in range(len(text) // 7, len(text) - 1, len(text) // 7):
            at = text.index("\n", at)
            edited = document.edited(text[:at] + mistake + text[at:])
            for _, statement in edited.placed():
                if len(statement.tokens) >= LARGE and not statement.problems:
                    whole = parse(statement)[1]
                    parts = problems_by_parts(statement, {})
                    assert problems_by_parts(statement, edited.parts) == parts
                    assert bool(whole) == bool(parts)
                    if mistake != "<":  # which swallows what follows, as far as the part reaches
                        assert [one.start for one in whole[:1]] == [one.start for one in parts[:1]]
