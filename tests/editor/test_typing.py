"""Scenes typed character by character over JSON-RPC, all requests asked on the way."""

from __future__ import annotations

from pathlib import Path

import pytest
from client import Client, end_of
from corpus import FILES
from lsprotocol import types
from minipov.grammar.text import decode

TYPED = 60
"""Characters."""

# Code, a form feed among the blanks, long runs of literal vectors, macros, a large open statement.
SAMPLES = ("abyss.pov", "superel2.pov", "teapot_sph.inc", "shapes.inc", "chess.inc")


@pytest.mark.parametrize("name", SAMPLES)
def test_typing_the_middle_of_a_file(client: Client, tmp_path: Path, name: str) -> None:
    file = next(file for file in FILES if file.name == name)
    text = decode(file.read_bytes())
    middle = len(text) // 2
    begun, typed = text[: middle - TYPED], text[middle - TYPED : middle]
    document, _ = client.open(tmp_path / name, begun)
    for length in range(TYPED):
        before = begun + typed[:length]
        client.type(document, end_of(before), typed[length])
        ask_everything(client, document, end_of(before + typed[length]))
    assert_it_knows(client, document, tmp_path / f"again-{name}", begun + typed)


def test_lines_end_where_the_client_ends_them(client: Client, tmp_path: Path) -> None:
    """A form feed, which Python takes for the end of a line, does not end one here; CR alone does."""
    document, _ = client.open(tmp_path / "lines.pov", "#declare A = 1;\f\r#declare B = 2;\r\nsphere { 0,  }\n")
    client.diagnostics(document)
    client.type(document, types.Position(2, 12), "A+B")
    assert client.diagnostics(document) == []
    assert_it_knows(
        client, document, tmp_path / "lines-again.pov", "#declare A = 1;\n#declare B = 2;\nsphere { 0, A+B }\n"
    )


def test_characters_beyond_ascii(client: Client, tmp_path: Path) -> None:
    document, _ = client.open(
        tmp_path / "beyond.pov", '// \N{GRINNING FACE}\n#debug "\N{GRINNING FACE}" sphere { 0,  }\n'
    )
    client.diagnostics(document)
    client.type(document, types.Position(1, 24), "Wide")
    (found,) = client.diagnostics(document)
    assert (found.range.start, found.range.end) == (types.Position(1, 24), types.Position(1, 28))


def ask_everything(client: Client, document: types.TextDocumentIdentifier, at: types.Position) -> None:
    """Every request; that none fails is the test."""
    ask = client.client
    context = types.ReferenceContext(True)
    for asked in (
        ask.text_document_completion_async(types.CompletionParams(document, at)),
        ask.text_document_hover_async(types.HoverParams(document, at)),
        ask.text_document_signature_help_async(types.SignatureHelpParams(document, at)),
        ask.text_document_definition_async(types.DefinitionParams(document, at)),
        ask.text_document_references_async(types.ReferenceParams(context, document, at)),
        ask.text_document_document_highlight_async(types.DocumentHighlightParams(document, at)),
        ask.text_document_document_symbol_async(types.DocumentSymbolParams(document)),
        ask.text_document_folding_range_async(types.FoldingRangeParams(document)),
        ask.text_document_semantic_tokens_full_async(types.SemanticTokensParams(document)),
        ask.text_document_document_color_async(types.DocumentColorParams(document)),
    ):
        client.wait(asked)


def assert_it_knows(client: Client, document: types.TextDocumentIdentifier, other: Path, text: str) -> None:
    """What is known of a text that was typed is what is known of it when it is opened."""
    fresh, _ = client.open(other, text)

    def known(one: types.TextDocumentIdentifier) -> list[object]:
        ask = client.client
        return [
            client.wait(ask.text_document_semantic_tokens_full_async(types.SemanticTokensParams(one))),
            client.wait(ask.text_document_document_symbol_async(types.DocumentSymbolParams(one))),
            client.wait(ask.text_document_folding_range_async(types.FoldingRangeParams(one))),
        ]

    assert known(document) == known(fresh)
