"""The files around a text: those that are open in the editor, and what ``#include`` finds on disk."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from os.path import abspath
from pathlib import Path
from typing import Final

from minipov.editor.analysis.document import Document
from minipov.editor.analysis.names import Declaration, exports_of, globals_of, includes, local_at, names_in
from minipov.grammar.text import decode
from minipov.interpreter.runtime.search import INCLUDE_EXTENSIONS, FileSearch

_LARGEST: Final = 8_000_000
"""Bytes beyond which an included file is not read: it is data."""


class Library:
    """Documents by path. ``folders`` are searched for includes after the folder of the text that names them."""

    def __init__(self, folders: tuple[Path, ...]) -> None:
        self.folders = folders
        self._open: dict[str, Document] = {}
        self._read: dict[str, tuple[tuple[int, int], Document]] = {}

    def put(self, path: str, text: str) -> Document:
        """Open a text, or take its next state."""
        before = self._open.get(path) or (self._read[path][1] if path in self._read else None)
        self._open[path] = Document(text, path) if before is None else before.edited(text)
        return self._open[path]

    def close(self, path: str) -> None:
        """Go back to what the disk holds."""
        self._open.pop(path, None)

    def get(self, path: str) -> Document | None:
        """The text at a path: as edited, or as on disk."""
        if path in self._open:
            return self._open[path]
        try:
            state = Path(path).stat()
            known = self._read.get(path)
            if known is None or known[0] != (state.st_mtime_ns, state.st_size):
                if state.st_size > _LARGEST:
                    return None
                known = (state.st_mtime_ns, state.st_size), Document(decode(Path(path).read_bytes()), path)
                self._read[path] = known
            return known[1]
        except (OSError, ValueError):
            return None

    def find(self, name: str, document: Document) -> Path | None:
        """The file that ``#include`` finds under a name."""
        beside = [Path(document.path).parent] if document.path else []
        found = FileSearch(self.folders, {}, beside).find(name, INCLUDE_EXTENSIONS)
        return found and Path(abspath(found))

    def is_in_folders(self, document: Document) -> bool:
        """Whether a text is one that several scenes share: it lies in a folder that is searched for includes."""
        return any(Path(document.path).is_relative_to(abspath(folder)) for folder in self.folders)

    def files_for(self, prefix: str, document: Document) -> list[str]:
        """Names of include files that begin with a prefix, which may hold folders."""
        folders = [*([Path(document.path).parent] if document.path else []), *self.folders]
        base, _, start = prefix.rpartition("/")
        found: dict[str, None] = {}
        for folder in folders:
            try:
                entries = sorted((folder / base).iterdir())
            except OSError:
                continue
            for entry in entries:
                if entry.name.startswith(start) and not entry.name.startswith("."):
                    name = f"{base}/{entry.name}" if base else entry.name
                    if entry.suffix.lower() in {".inc", ".mac", ".map"}:
                        found[name] = None
                    elif entry.is_dir() and folder == folders[0]:
                        found[name + "/"] = None
        return list(found)

    def chain(self, document: Document) -> list[Document]:
        """The text and all that it includes, directly or not."""
        found: dict[str, Document] = {}

        def add(one: Document) -> None:
            found[one.path] = one
            for include in includes(one):
                path = self.find(include.file, one)
                if path is not None and str(path) not in found and (next_ := self.get(str(path))) is not None:
                    add(next_)

        add(document)
        return list(found.values())

    def including(self, documents: Sequence[Document]) -> list[Document]:
        """The open texts that are one of these or include one."""
        paths = {document.path for document in documents}
        return [one for one in self._open.values() if any(part.path in paths for part in self.chain(one))]

    def around(self, documents: Sequence[Document]) -> list[Document]:
        """These texts, the open texts that include one, and all that any of them includes."""
        chains = [self.chain(one) for one in (*documents, *self.including(documents))]
        return list({part.path: part for chain in chains for part in chain}.values())

    def is_complete(self, documents: list[Document]) -> bool:
        """Whether every file that the texts include is known and was found."""
        for document in documents:
            if any(names_in(statement).computed_include for statement in document.statements):
                return False
            if any(self.find(include.file, document) is None for include in includes(document)):
                return False
        return True

    def declared(self, document: Document) -> Iterator[tuple[Document, Declaration]]:
        """Every name that holds everywhere in the text, with the file that declares it."""
        for one in self.chain(document):
            for declaration in self._seen_from(document, one).values():
                yield one, declaration

    def lookup(self, document: Document, name: str, offset: int) -> tuple[Document, Declaration] | None:
        """Where the name that stands at an offset is declared."""
        local = local_at(document, name, offset)
        if local is not None:
            return document, local
        for one in self.chain(document):
            found = self._seen_from(document, one).get(name)
            if found is not None:
                return one, found
        return None

    def _seen_from(self, document: Document, included: Document) -> dict[str, Declaration]:
        return globals_of(document) if included is document else exports_of(included)
