"""Requests about a whole text: outline, folding, semantic tokens, colours."""

from __future__ import annotations

from typing import Final

from lsprotocol import types
from minipov.editor.analysis.colors import color_literals, written
from minipov.editor.analysis.highlighting import highlights
from minipov.editor.analysis.outline import folds, outline
from minipov.editor.server.session import Session

_SYMBOL_KINDS: Final = {
    "macro": types.SymbolKind.Function,
    "function": types.SymbolKind.Function,
    "value": types.SymbolKind.Variable,
    "file": types.SymbolKind.File,
    "block": types.SymbolKind.Object,
}
_TOKEN_TYPES: Final = {
    "macro": "macro", "function": "function", "value": "variable", "parameter": "parameter", "counter": "variable",
    "file": "variable",
}  # fmt: skip
_LEGEND: Final = types.SemanticTokensLegend(sorted(set(_TOKEN_TYPES.values())), ["declaration"])


def register(server: Session) -> None:
    """Enter the requests into a server."""
    server.feature(types.TEXT_DOCUMENT_DOCUMENT_SYMBOL)(document_symbols)
    server.feature(types.TEXT_DOCUMENT_FOLDING_RANGE)(folding_ranges)
    server.feature(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL, _LEGEND)(semantic_tokens)
    server.feature(types.TEXT_DOCUMENT_DOCUMENT_COLOR)(document_colors)
    server.feature(types.TEXT_DOCUMENT_COLOR_PRESENTATION)(color_presentations)


def document_symbols(server: Session, params: types.DocumentSymbolParams) -> list[types.DocumentSymbol]:
    """The outline."""
    document, positions = server.document(params.text_document.uri)
    return [
        types.DocumentSymbol(
            entry.name,
            _SYMBOL_KINDS[entry.kind],
            positions.range(entry.from_, max(entry.to, entry.end)),
            positions.range(entry.start, entry.end),
            detail=entry.detail,
        )
        for entry in outline(document)
    ]


def folding_ranges(server: Session, params: types.FoldingRangeParams) -> list[types.FoldingRange]:
    """Blocks, directive bodies, comments."""
    document, _ = server.document(params.text_document.uri)
    return [
        types.FoldingRange(first, last, kind=types.FoldingRangeKind.Comment if is_comment else None)
        for first, last, is_comment in folds(document)
    ]


def semantic_tokens(server: Session, params: types.SemanticTokensParams) -> types.SemanticTokens:
    """What identifiers stand for, in the protocol's running differences."""
    document, positions = server.document(params.text_document.uri)
    kinds = {kind: _LEGEND.token_types.index(name) for kind, name in _TOKEN_TYPES.items()}
    data: list[int] = []
    line = character = 0
    for offset, length, kind, declared in highlights(document, server.library):
        at = positions.position(offset)
        character = at.character - (character if at.line == line else 0)
        data += (at.line - line, character, length, kinds[kind], int(declared))
        line, character = at.line, at.character
    return types.SemanticTokens(data)


def document_colors(server: Session, params: types.DocumentColorParams) -> list[types.ColorInformation]:
    """Colour literals."""
    document, positions = server.document(params.text_document.uri)
    return [
        types.ColorInformation(positions.range(literal.start, literal.end), types.Color(*literal.shown, 1.0))
        for literal in color_literals(document)
    ]


def color_presentations(server: Session, params: types.ColorPresentationParams) -> list[types.ColorPresentation]:
    """How a chosen colour is written."""
    document, positions = server.document(params.text_document.uri)
    start = positions.offset(params.range.start)
    chosen = (params.color.red, params.color.green, params.color.blue)
    return [
        types.ColorPresentation(text, types.TextEdit(params.range, text))
        for text in (written(one, document, chosen) for one in color_literals(document) if one.start == start)
    ]
