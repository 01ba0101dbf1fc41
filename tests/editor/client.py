"""A client of `minipov lsp` for tests: the real process, spoken to over its pipes."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Coroutine
from pathlib import Path
from typing import Any, TypeVar

from lsprotocol import types
from pygls.lsp.client import LanguageClient

T = TypeVar("T")


def end_of(text: str) -> types.Position:
    """The position behind a text of ASCII characters."""
    return types.Position(text.count("\n"), len(text) - text.rfind("\n") - 1)


class Client:
    """Starts the server; ``^`` in a text that is opened marks a position."""

    def __init__(self) -> None:
        self.loop = asyncio.new_event_loop()
        self.client = LanguageClient("minipov tests", "1")
        self.published: dict[str, list[types.Diagnostic]] = {}
        self.news: asyncio.Event = asyncio.Event()
        self.client.feature(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)(lambda params: self._published(params))
        self.versions: dict[str, int] = {}
        self.complaints: list[str] = []
        self.client.feature(types.WINDOW_SHOW_MESSAGE)(lambda params: self.complaints.append(params.message))

    def __enter__(self) -> Client:
        self.wait(self.client.start_io(sys.executable, "-m", "minipov", "lsp"))
        item = types.ClientCompletionItemOptions(snippet_support=True)
        text = types.TextDocumentClientCapabilities(completion=types.CompletionClientCapabilities(completion_item=item))
        capabilities = types.ClientCapabilities(text_document=text)
        self.started = self.wait(self.client.initialize_async(types.InitializeParams(capabilities=capabilities)))
        self.client.initialized(types.InitializedParams())
        return self

    def __exit__(self, *_: object) -> None:
        self.wait(self.client.shutdown_async(None))
        self.client.exit(None)
        self.wait(self.client.stop())
        self.loop.close()
        assert self.complaints == []

    def wait(self, coroutine: Coroutine[Any, Any, T]) -> T:
        """Run until the answer is there."""
        return self.loop.run_until_complete(asyncio.wait_for(coroutine, 60))

    def _published(self, params: types.PublishDiagnosticsParams) -> None:
        self.published[params.uri] = list(params.diagnostics)
        self.news.set()

    def open(self, path: Path, text: str) -> tuple[types.TextDocumentIdentifier, types.Position]:
        """Open a text; gives its identifier and the position of ``^``."""
        before, _, after = text.partition("^")
        uri = path.as_uri()
        self.client.text_document_did_open(
            types.DidOpenTextDocumentParams(types.TextDocumentItem(uri, "povray", 1, before + after))
        )
        self.versions[uri] = 1
        return types.TextDocumentIdentifier(uri), end_of(before)

    def type(self, document: types.TextDocumentIdentifier, at: types.Position, text: str) -> None:
        """Put characters in at a position, as an editor does for each key."""
        self.versions[document.uri] += 1
        self.client.text_document_did_change(
            types.DidChangeTextDocumentParams(
                types.VersionedTextDocumentIdentifier(self.versions[document.uri], document.uri),
                [types.TextDocumentContentChangePartial(types.Range(at, at), text)],
            )
        )

    def change(self, document: types.TextDocumentIdentifier, text: str) -> None:
        """Replace the whole text."""
        self.versions[document.uri] += 1
        self.client.text_document_did_change(
            types.DidChangeTextDocumentParams(
                types.VersionedTextDocumentIdentifier(self.versions[document.uri], document.uri),
                [types.TextDocumentContentChangeWholeDocument(text)],
            )
        )

    def diagnostics(self, document: types.TextDocumentIdentifier) -> list[types.Diagnostic]:
        """What the server says next about a text."""
        self.published.pop(document.uri, None)

        async def arrived() -> list[types.Diagnostic]:
            while document.uri not in self.published:
                self.news.clear()
                await self.news.wait()
            return self.published[document.uri]

        return self.wait(arrived())
