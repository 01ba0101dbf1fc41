"""Requests about the word at a position: completion, hover, signature, definition, references, rename."""

from __future__ import annotations

import re
from typing import Final, Protocol

from lsprotocol import types
from minipov.editor.analysis.completion import Completion, CompletionKind, completions
from minipov.editor.analysis.help import help_at
from minipov.editor.analysis.names import includes
from minipov.editor.analysis.references import Reference, references as all_references, references_here
from minipov.editor.analysis.signatures import signature_at
from minipov.editor.server.positions import Positions
from minipov.editor.server.session import Session
from minipov.grammar.keywords import KEYWORDS
from pygls import uris
from pygls.exceptions import JsonRpcInvalidParams

_KINDS: Final[dict[CompletionKind, types.CompletionItemKind]] = {
    "block": types.CompletionItemKind.Class,
    "keyword": types.CompletionItemKind.Keyword,
    "function": types.CompletionItemKind.Function,
    "constant": types.CompletionItemKind.Constant,
    "name": types.CompletionItemKind.Variable,
    "macro": types.CompletionItemKind.Function,
    "file": types.CompletionItemKind.File,
    "member": types.CompletionItemKind.Field,
}
_NAME: Final = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")


class _Place(Protocol):
    """The parameters of all requests about a position."""

    text_document: types.TextDocumentIdentifier
    position: types.Position


def register(server: Session) -> None:
    """Enter the requests into a server."""
    server.feature(types.TEXT_DOCUMENT_COMPLETION, types.CompletionOptions(trigger_characters=["#", '"', ".", "/"]))(
        complete
    )
    server.feature(types.TEXT_DOCUMENT_HOVER)(hover)
    server.feature(types.TEXT_DOCUMENT_SIGNATURE_HELP, types.SignatureHelpOptions(trigger_characters=["(", ","]))(
        signature_help
    )
    server.feature(types.TEXT_DOCUMENT_DEFINITION)(definition)
    server.feature(types.TEXT_DOCUMENT_REFERENCES)(references)
    server.feature(types.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT)(document_highlight)
    server.feature(types.TEXT_DOCUMENT_RENAME, types.RenameOptions(prepare_provider=True))(rename)
    server.feature(types.TEXT_DOCUMENT_PREPARE_RENAME)(prepare_rename)


def complete(server: Session, params: types.CompletionParams) -> types.CompletionList:
    """Words that fit."""
    document, positions = server.document(params.text_document.uri)
    offset = positions.offset(params.position)
    capabilities = server.client_capabilities.text_document
    item = capabilities and capabilities.completion and capabilities.completion.completion_item
    snippets = bool(item and item.snippet_support)
    found = completions(document, server.library, offset)
    return types.CompletionList(False, [_item(one, positions, offset, snippets) for one in found])


def _item(one: Completion, positions: Positions, offset: int, snippets: bool) -> types.CompletionItem:
    insert = one.insert if snippets and one.insert else one.word
    return types.CompletionItem(
        one.word,
        kind=_KINDS[one.kind],
        detail=one.detail or None,
        sort_text=f"{one.rank}{one.word.lower()}",
        insert_text_format=types.InsertTextFormat.Snippet if insert != one.word else types.InsertTextFormat.PlainText,
        text_edit=types.TextEdit(positions.range(one.start, offset), insert),
    )


def hover(server: Session, params: types.HoverParams) -> types.Hover | None:
    """Signature and meaning of a word."""
    document, positions = server.document(params.text_document.uri)
    found = help_at(document, server.library, positions.offset(params.position))
    if found is None:
        return None
    markdown = f"```povray\n{found.code}\n```\n\n{found.text}"
    return types.Hover(
        types.MarkupContent(types.MarkupKind.Markdown, markdown), positions.range(found.start, found.end)
    )


def signature_help(server: Session, params: types.SignatureHelpParams) -> types.SignatureHelp | None:
    """Parameters of the call that is being typed."""
    document, positions = server.document(params.text_document.uri)
    found = signature_at(document, server.library, positions.offset(params.position))
    if found is None:
        return None
    parameters = [types.ParameterInformation(name) for name in found.parameters]
    signature = types.SignatureInformation(found.text, found.comment or None, parameters)
    return types.SignatureHelp([signature], 0, found.argument)


def definition(server: Session, params: types.DefinitionParams) -> types.Location | None:
    """Where a name is declared, or the file that is included."""
    document, positions = server.document(params.text_document.uri)
    offset = positions.offset(params.position)
    for include in includes(document):
        if include.start <= offset <= include.end:
            path = server.library.find(include.file, document)
            uri = path and uris.from_fs_path(str(path.absolute()))
            return types.Location(uri, types.Range(types.Position(0, 0), types.Position(0, 0))) if uri else None
    name = _name_at(server, params)
    found = server.library.lookup(document, name[0], name[1]) if name else None
    if found is None:
        return None
    other, declaration = found
    return types.Location(server.uri(other), server.positions(other).range(declaration.start, declaration.end))


def references(server: Session, params: types.ReferenceParams) -> list[types.Location]:
    """Where the name stands, in this text and those around it."""
    wanted = params.context.include_declaration
    return [
        types.Location(server.uri(one.document), server.positions(one.document).range(one.start, one.end))
        for one in _references(server, params)
        if wanted or not one.declares
    ]


def document_highlight(server: Session, params: types.DocumentHighlightParams) -> list[types.DocumentHighlight]:
    """Where it stands in this text, to be marked."""
    document, positions = server.document(params.text_document.uri)
    name = _name_at(server, params)
    found = references_here(document, *name) if name else ()
    return [types.DocumentHighlight(positions.range(one.start, one.end)) for one in found]


def prepare_rename(server: Session, params: types.PrepareRenameParams) -> types.Range | None:
    """The name that would be renamed."""
    name = _name_at(server, params)
    if name is None:
        return None
    _to_rename(server, params)
    _, positions = server.document(params.text_document.uri)
    return positions.range(name[1], name[1] + len(name[0]))


def rename(server: Session, params: types.RenameParams) -> types.WorkspaceEdit:
    """Rename in this text and those around it."""
    new = params.new_name
    if not _NAME.fullmatch(new) or new in KEYWORDS:
        raise JsonRpcInvalidParams(f"'{new}' is not a name that SDL would take")
    changes: dict[str, list[types.TextEdit]] = {}
    for one in _to_rename(server, params):
        place = server.positions(one.document).range(one.start, one.end)
        changes.setdefault(server.uri(one.document), []).append(types.TextEdit(place, new))
    return types.WorkspaceEdit(changes=changes)


def _to_rename(server: Session, params: _Place) -> list[Reference]:
    """The places, none of them in another text of the library, which scenes share."""
    document, _ = server.document(params.text_document.uri)
    found = _references(server, params)
    for one in found:
        if one.document is not document and server.library.is_in_folders(one.document):
            raise JsonRpcInvalidParams(f"the name also stands in {one.document.path}, which all scenes share")
    return found


def _references(server: Session, params: _Place) -> list[Reference]:
    document, _ = server.document(params.text_document.uri)
    name = _name_at(server, params)
    return list(all_references(document, server.library, *name)) if name else []


def _name_at(server: Session, params: _Place) -> tuple[str, int] | None:
    """The identifier at a position, and where it begins."""
    document, positions = server.document(params.text_document.uri)
    found = document.token_at(positions.offset(params.position))
    if found is None or found[0].type != "NAME":
        return None
    return str(found[0].value), found[1] + (found[0].start_pos or 0)
