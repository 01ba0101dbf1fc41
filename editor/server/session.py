"""The server with the texts that its client has open."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from importlib.metadata import version
from os.path import abspath
from pathlib import Path
from typing import Final

from lsprotocol import types
from minipov.editor.analysis.checks import problems
from minipov.editor.analysis.document import Document, line_starts
from minipov.editor.analysis.library import Library
from minipov.editor.analysis.problem import Problem
from minipov.editor.server.positions import Positions
from pygls import uris
from pygls.lsp.server import LanguageServer

_PAUSE: Final = 0.1
"""Seconds without typing after which a text is checked."""


class Session(LanguageServer):
    """A language server with a library of SDL texts."""

    def __init__(self, folders: tuple[Path, ...]) -> None:
        super().__init__("minipov", version("minipov"), max_workers=1)
        self.library = Library(folders)
        self._uris: dict[str, str] = {}
        self._waiting: dict[str, asyncio.Task[None]] = {}

    def document(self, uri: str) -> tuple[Document, Positions]:
        """The text of a request, with the translation of its positions."""
        path = _path(uri)
        document = self.library.get(path) or Document("", path)
        return document, self.positions(document)

    def positions(self, document: Document) -> Positions:
        """The translation of positions in a document."""
        return Positions(document.text, document.line_starts, self.workspace.position_codec)

    def uri(self, document: Document) -> str:
        """The address of a document, as the client writes it if it has opened it."""
        path = document.path
        return self._uris.get(path) or uris.from_fs_path(abspath(path)) or path

    def take(self, uri: str, text: str) -> Document:
        """Take over a text as the client has it now, with lines that end as SDL's do for us."""
        self._uris[_path(uri)] = uri
        return self.library.put(_path(uri), text.replace("\r\n", "\n").replace("\r", "\n"))

    def edit(self, uri: str, changes: Sequence[types.TextDocumentContentChangeEvent]) -> None:
        """Make the changes, each to what the one before it left.

        Not left to pygls, to which a form feed ends a line.
        """
        text = self.document(uri)[0].text
        for change in changes:
            if isinstance(change, types.TextDocumentContentChangePartial):
                positions = Positions(text, line_starts(text), self.workspace.position_codec)
                start, end = positions.offset(change.range.start), positions.offset(change.range.end)
                text = text[:start] + change.text + text[end:]
            else:
                text = change.text
        self.take(uri, text)

    def forget(self, uri: str) -> None:
        """A text was closed."""
        self._wait_no_more(uri)
        self.library.close(_path(uri))
        self._publish(uri, [])

    def check_soon(self, uri: str) -> None:
        """Check a text when typing pauses."""
        self._wait_no_more(uri)
        self._waiting[uri] = asyncio.get_running_loop().create_task(self._check_later(uri))

    def _wait_no_more(self, uri: str) -> None:
        waiting = self._waiting.pop(uri, None)
        if waiting is not None:
            waiting.cancel()

    async def _check_later(self, uri: str) -> None:
        await asyncio.sleep(_PAUSE)
        self._waiting.pop(uri, None)
        self.check(uri)

    def check(self, uri: str) -> None:
        """Tell the client what is wrong in a text."""
        self._check(self.document(uri)[0])

    def check_around(self, uri: str) -> None:
        """Tell the client what is wrong in a text, and in the open texts that include it."""
        document, _ = self.document(uri)
        for one in self.library.including([document]):
            self._check(one)

    def _check(self, document: Document) -> None:
        uri, positions = self.uri(document), self.positions(document)
        found = problems(document, self.library)
        self._publish(uri, [_diagnostic(problem, positions, uri) for problem in found])

    def _publish(self, uri: str, diagnostics: list[types.Diagnostic]) -> None:
        self.text_document_publish_diagnostics(types.PublishDiagnosticsParams(uri, diagnostics))


def _path(uri: str) -> str:
    path = uris.to_fs_path(uri) if uri.startswith("file:") else None
    return path or uri


def _diagnostic(problem: Problem, positions: Positions, uri: str) -> types.Diagnostic:
    related = None
    if problem.opened is not None:
        opened = types.Location(uri, positions.range(problem.opened, problem.opened + 1))
        related = [types.DiagnosticRelatedInformation(opened, "opened here")]
    severity = types.DiagnosticSeverity.Error if problem.certain else types.DiagnosticSeverity.Warning
    message = f"{problem.message} ({problem.hint})" if problem.hint else problem.message
    place = positions.range(problem.start, problem.end)
    return types.Diagnostic(place, message, severity, source="minipov", related_information=related)
