"""The server with all its requests."""

from __future__ import annotations

from pathlib import Path

from lsprotocol import types
from minipov.editor.server import text_requests, word_requests
from minipov.editor.server.session import Session


def language_server(folders: tuple[Path, ...]) -> Session:
    """A server that looks for includes in ``folders``."""
    server = Session(folders)
    server.feature(types.TEXT_DOCUMENT_DID_OPEN)(opened)
    server.feature(types.TEXT_DOCUMENT_DID_CHANGE)(changed)
    server.feature(types.TEXT_DOCUMENT_DID_SAVE)(saved)
    server.feature(types.TEXT_DOCUMENT_DID_CLOSE)(closed)
    word_requests.register(server)
    text_requests.register(server)
    return server


def opened(server: Session, params: types.DidOpenTextDocumentParams) -> None:
    """A text is to be watched."""
    server.take(params.text_document.uri, params.text_document.text)
    server.check(params.text_document.uri)


async def changed(server: Session, params: types.DidChangeTextDocumentParams) -> None:
    """Something was typed."""
    server.edit(params.text_document.uri, params.content_changes)
    server.check_soon(params.text_document.uri)


def saved(server: Session, params: types.DidSaveTextDocumentParams) -> None:
    """What includes this text sees what it is now."""
    server.check_around(params.text_document.uri)


def closed(server: Session, params: types.DidCloseTextDocumentParams) -> None:
    """A text is no longer watched."""
    server.forget(params.text_document.uri)
