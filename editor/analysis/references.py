"""Where a name stands for the same thing: in its text, in what this includes, in open texts that include it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from minipov.editor.analysis.document import Document
from minipov.editor.analysis.library import Library
from minipov.editor.analysis.names import Declaration, exports_of, globals_of, local_at, names_in


@dataclass(frozen=True, slots=True)
class Reference:
    """A place where a name stands; ``declares`` says that it is declared there."""

    document: Document
    start: int
    end: int
    declares: bool


def references(document: Document, library: Library, name: str, offset: int) -> Iterator[Reference]:
    """All places where the name that stands at an offset stands for the same thing.

    Of the texts that include this one, those that are open are looked at.
    """
    yield from references_here(document, name, offset)
    found = library.lookup(document, name, offset)
    if found is not None and (found[1].scope or found[1].in_file):
        return
    for one in library.around([document] if found is None else [document, found[0]]):
        if one.path != document.path and not _is_of_file(one, name):
            yield from _standing_for(one, name, None)


def references_here(document: Document, name: str, offset: int) -> Iterator[Reference]:
    """Those of them in the text itself."""
    local = local_at(document, name, offset)
    yield from _standing_for(document, name, local)


def _standing_for(document: Document, name: str, local: Declaration | None) -> Iterator[Reference]:
    """Where a name stands for a local declaration, or for none."""
    for start, statement in document.placed():
        names = names_in(statement)
        declared = {declaration.start for declaration in names.declared}
        for token in names.used:
            if token.value == name:
                at = token.start_pos or 0
                if local_at(document, name, start + at) == local:
                    yield Reference(document, start + at, start + at + len(name), at in declared)


def _is_of_file(document: Document, name: str) -> bool:
    """Whether a name ends with the text that declares it."""
    return name in globals_of(document) and name not in exports_of(document)
