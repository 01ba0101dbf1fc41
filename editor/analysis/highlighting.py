"""What identifiers stand for, which keywords alone cannot tell: macros, functions, parameters, variables."""

from __future__ import annotations

from collections.abc import Iterator

from minipov.editor.analysis.document import Document
from minipov.editor.analysis.library import Library
from minipov.editor.analysis.names import NameKind, locals_at, names_in


def highlights(document: Document, library: Library) -> Iterator[tuple[int, int, NameKind, bool]]:
    """Offset, length and kind of each declared name, and whether it is declared there."""
    kinds: dict[str, NameKind] = {}
    for _, declaration in library.declared(document):
        kinds.setdefault(declaration.name, declaration.kind)
    for start, statement in document.placed():
        names = names_in(statement)
        if not names.used:
            continue
        declared = {d.start: d for d in names.declared}
        scoped = {d.name for d in names.declared if d.scope is not None}
        for token in names.used:
            at, name = token.start_pos or 0, str(token.value)
            kind = kinds.get(name)
            if at in declared:
                kind = declared[at].kind
            elif name in scoped:
                inner = [d for d in locals_at(document, start + at) if d.name == name]
                kind = inner[-1].kind if inner else kind
            if kind is not None:
                yield start + at, len(name), kind, at in declared
