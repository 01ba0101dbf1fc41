"""The server with the texts that its client has open."""

from __future__ import annotations

import asyncio
from importlib.metadata import version
from pathlib import Path
from typing import Final

from lsprotocol import types
from minipov.editor.analysis.checks import problems
from minipov.editor.analysis.document import Document
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
        self._waiting: dict[str, asyncio.Task[None]] = {}

    def document(self, uri: str) -> tuple[Document, Positions]:
        """The text of a request, with the translation of its positions."""
        document = self.library.get(_path(uri))
        if document is None:
            document = self.take(uri)
        return document, self.positions(document)

    def positions(self, document: Document) -> Positions:
        """The translation of positions in a document."""
        return Positions(document, self.workspace.position_codec)

    def take(self, uri: str) -> Document:
        """Take over the text as the client has it now."""
        return self.library.put(_path(uri), self.workspace.get_text_document(uri).source)

    def forget(self, uri: str) -> None:
        """A text was closed."""
        self.library.close(_path(uri))
        self._publish(uri, [])

    def check_soon(self, uri: str) -> None:
        """Check a text when typing pauses."""
        waiting = self._waiting.pop(uri, None)
        if waiting is not None:
            waiting.cancel()
        self._waiting[uri] = asyncio.get_running_loop().create_task(self._check_later(uri))

    async def _check_later(self, uri: str) -> None:
        await asyncio.sleep(_PAUSE)
        self._waiting.pop(uri, None)
        self.check(uri)

    def check(self, uri: str) -> None:
        """Tell the client what is wrong in a text."""
        document, positions = self.document(uri)
        found = problems(document, self.library)
        self._publish(uri, [_diagnostic(problem, positions, uri) for problem in found])

    def _publish(self, uri: str, diagnostics: list[types.Diagnostic]) -> None:
        self.text_document_publish_diagnostics(types.PublishDiagnosticsParams(uri, diagnostics))


def uri_of(document: Document) -> str:
    """The address of a document, for the client."""
    if "://" in document.path or document.path.startswith("untitled:"):
        return document.path
    return uris.from_fs_path(str(Path(document.path).absolute())) or document.path


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
