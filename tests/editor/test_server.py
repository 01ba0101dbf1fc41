"""Each request, asked of the real `minipov lsp` over JSON-RPC."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest
from client import Client
from lsprotocol import types
from pygls.exceptions import JsonRpcException
from running import MINIPOV

SCENE = """#version 3.7;
#include "colors.inc"
// how large the ball is
#declare Size = 2*pi;
#macro Ball(P, R)
  sphere { P, R pigment { Red } }
#end
Ball(<1, 2, 3>, Size)
sphere { 0, Size pigment { rgb <1, 0.5, 0> } }
"""


def test_it_says_what_it_can(client: Client) -> None:
    can = client.started.capabilities
    assert client.started.server_info is not None
    assert client.started.server_info.name == "minipov"
    assert can.hover_provider
    assert can.completion_provider
    assert can.rename_provider


def test_diagnostics_while_typing(client: Client, tmp_path: Path) -> None:
    document, _ = client.open(tmp_path / "a.pov", "sphere { <0, 0, 0, 1 }\nbox { 0, 1 }\n")
    (found,) = client.diagnostics(document)
    assert "expected '>'" in found.message
    assert found.range.start == types.Position(0, 21)
    assert found.severity == types.DiagnosticSeverity.Error
    assert found.related_information is not None
    assert found.related_information[0].location.range.start == types.Position(0, 9)
    client.change(document, "sphere { <0, 0, 0>, Radius }\nbox { 0, 1 }\n")
    (found,) = client.diagnostics(document)
    assert "unknown name 'Radius'" in found.message
    assert found.severity == types.DiagnosticSeverity.Warning
    client.change(document, "#declare Radius = 1;\nsphere { <0, 0, 0>, Radius }\nbox { 0, 1 }\n")
    assert client.diagnostics(document) == []


def test_several_mistakes_are_found_at_once(client: Client, tmp_path: Path) -> None:
    text = '#declare = 3;\nsphere { 0, 1 pigmnet { rgb 1 } }\n#include "colours.inc"\ncamera { radius 3 }\n#foo\n'
    document, _ = client.open(tmp_path / "b.inc", text)
    lines = [found.range.start.line for found in client.diagnostics(document)]
    assert lines == [0, 2, 3, 4]


@pytest.mark.parametrize("last_words", [("shutdown", "exit"), ()], ids=["told to", "client gone"])
def test_it_ends_without_a_word(last_words: tuple[str, ...]) -> None:
    capabilities = {"processId": None, "rootUri": None, "capabilities": {}}
    messages = [{"id": 1, "method": "initialize", "params": capabilities}]
    messages += [{"id": 2, "method": word} if word == "shutdown" else {"method": word} for word in last_words]
    bodies = [json.dumps({"jsonrpc": "2.0", **message}).encode() for message in messages]
    said = b"".join(b"Content-Length: %d\r\n\r\n%s" % (len(body), body) for body in bodies)
    run = subprocess.run([*MINIPOV, "lsp"], input=said, capture_output=True, timeout=60, check=False)
    assert (run.returncode, run.stderr.decode()) == (0, "")


def test_closing_takes_the_diagnostics_away(client: Client, tmp_path: Path) -> None:
    document, _ = client.open(tmp_path / "c.pov", "#end")
    assert len(client.diagnostics(document)) == 1
    client.client.text_document_did_close(types.DidCloseTextDocumentParams(document))
    assert client.diagnostics(document) == []


@pytest.mark.parametrize(
    ("text", "wanted", "unwanted"),
    [
        ("sphere { 0, 1 finish { ph^ } }", "phong_size", "camera"),
        ("sphere { 0, 1 ^ }", "pigment", "assumed_gamma"),
        ("^", "global_settings", "phong"),
        ("#de^", "declare", "sphere"),
        ("#declare Wide = 3; sphere { 0, W^ }", "Wide", "missing"),
        ('#include "col^"', "colors.inc", "sphere"),
        ('#include "colors.inc"\nsphere { 0, 1 pigment { R^ } }', "Red", "fog"),
        ("#macro M(Left, Right) #local Inner = 1; ^ #end", "Inner", "Other"),
        ("#declare A = <1,2,3>; #declare B = A.^", "x", "sphere"),
        ("sphere { 0, sq^ }", "sqrt", "fog"),
        ("#declare A = sp^", "sphere", "spotlight"),
        ("union { bo^ }", "box", "fog"),
    ],
)
def test_completion(client: Client, tmp_path: Path, text: str, wanted: str, unwanted: str) -> None:
    document, position = client.open(tmp_path / "d.pov", text)
    answer = client.wait(client.client.text_document_completion_async(types.CompletionParams(document, position)))
    assert isinstance(answer, types.CompletionList)
    words = [item.label for item in answer.items]
    assert wanted in words
    assert unwanted not in words
    assert len(words) == len(set(words))


def test_completion_offers_nothing_in_comments(client: Client, tmp_path: Path) -> None:
    document, position = client.open(tmp_path / "e.pov", "sphere { 0, 1 } // a^")
    answer = client.wait(client.client.text_document_completion_async(types.CompletionParams(document, position)))
    assert isinstance(answer, types.CompletionList)
    assert list(answer.items) == []


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("sph^ere { 0, 1 }", ["sphere { center, radius [modifiers] }", "A ball."]),
        ("sphere { 0, 1 finish { phong_s^ize 3 } }", ["Default in finish: 40"]),
        ("#declare A = si^n(1);", ["sin(A)", "ine of A radians"]),
        (SCENE.replace("Ball(<1", "Ba^ll(<1"), ["#macro Ball(P, R)", "line 5"]),
        (SCENE.replace("0, Size", "0, Si^ze"), ["#declare Size = 2*pi;", "= 6.28319", "how large the ball is"]),
        (SCENE.replace("Red", "R^ed"), ["rgb <1, 0, 0>", "colors.inc"]),
        ('#inc^lude "colors.inc"', ["Reads another file here."]),
        ('#include "colo^rs.inc"', ["colors.inc"]),
    ],
)
def test_hover(client: Client, tmp_path: Path, text: str, parts: list[str]) -> None:
    document, position = client.open(tmp_path / "f.pov", text)
    answer = client.wait(client.client.text_document_hover_async(types.HoverParams(document, position)))
    assert answer is not None
    assert isinstance(answer.contents, types.MarkupContent)
    for part in parts:
        assert part in answer.contents.value


def test_hover_on_nothing(client: Client, tmp_path: Path) -> None:
    document, position = client.open(tmp_path / "g.pov", "sphere { 0, 1 }\n^\n")
    assert client.wait(client.client.text_document_hover_async(types.HoverParams(document, position))) is None


@pytest.mark.parametrize(
    ("call", "label", "argument"),
    [
        ("Ball(<1, 2, 3>, ^", "Ball(P, R)", 1),
        ("Ball(<1, ^", "Ball(P, R)", 0),
        ("#declare A = vaxis_rotate(x, y, ^", "vaxis_rotate(V, axis, degrees)", 2),
        ("#declare F = function(a, b) { a*b }\n#declare G = F(1, ^", "F(a, b)", 1),
    ],
)
def test_signature_help(client: Client, tmp_path: Path, call: str, label: str, argument: int) -> None:
    document, position = client.open(tmp_path / "h.pov", SCENE + call)
    params = types.SignatureHelpParams(document, position)
    answer = client.wait(client.client.text_document_signature_help_async(params))
    assert answer is not None
    assert (answer.signatures[0].label, answer.active_parameter) == (label, argument)


@pytest.mark.parametrize(
    ("text", "file", "line"),
    [
        (SCENE.replace("0, Size", "0, Si^ze"), "i.pov", 3),
        (SCENE.replace("{ P, R", "{ P^, R"), "i.pov", 4),
        (SCENE.replace("Red", "R^ed"), "colors.inc", None),
        (SCENE.replace("colors.inc", "col^ors.inc"), "colors.inc", 0),
    ],
)
def test_definition(client: Client, tmp_path: Path, text: str, file: str, line: int | None) -> None:
    document, position = client.open(tmp_path / "i.pov", text)
    answer = client.wait(client.client.text_document_definition_async(types.DefinitionParams(document, position)))
    assert isinstance(answer, types.Location)
    assert answer.uri.endswith(file)
    if line is not None:
        assert answer.range.start.line == line


def test_references_keep_to_their_scope(client: Client, tmp_path: Path) -> None:
    text = "#declare A = 1;\n#macro M(A) A+1 #end\nsphere { A^, M(A) }\n"
    document, position = client.open(tmp_path / "j.pov", text)
    params = types.ReferenceParams(types.ReferenceContext(True), document, position)
    answer = client.wait(client.client.text_document_references_async(params))
    assert answer is not None
    places = [(place.range.start.line, place.range.start.character) for place in answer]
    assert places == [(0, 9), (2, 9), (2, 14)]
    marks = client.wait(
        client.client.text_document_document_highlight_async(types.DocumentHighlightParams(document, position))
    )
    assert marks is not None
    assert [mark.range for mark in marks] == [place.range for place in answer]


def test_rename(client: Client, tmp_path: Path) -> None:
    text = "#macro M(Old) sphere { Ol^d, 1 } #end\n#declare Old = 1;\n"
    document, position = client.open(tmp_path / "k.pov", text)
    where = client.wait(client.client.text_document_prepare_rename_async(types.PrepareRenameParams(document, position)))
    assert isinstance(where, types.Range)
    assert (where.start.character, where.end.character) == (23, 26)
    answer = client.wait(client.client.text_document_rename_async(types.RenameParams(document, position, "New")))
    assert answer is not None
    assert answer.changes is not None
    assert [edit.range.start.character for edit in answer.changes[document.uri]] == [9, 23]
    with pytest.raises(JsonRpcException, match="not a name"):
        client.wait(client.client.text_document_rename_async(types.RenameParams(document, position, "sphere")))


Three = tuple[types.TextDocumentIdentifier, types.Position]


@pytest.fixture
def three_texts(client: Client, tmp_path: Path) -> Three:
    """A scene, a closed include whose macro it calls, and another open scene that includes this too."""
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts/ball.inc").write_text("#local Wide = 2;\n#macro Ball(R) sphere { 0, R*Wide } #end\n")
    client.open(tmp_path / "parts/other.pov", '#include "ball.inc"\n#local Wide = 5;\nBall(Wide)\n')
    client.open(tmp_path / "alone.pov", "#macro Ball() #end Ball()\n")
    return client.open(tmp_path / "scene.pov", '#include "parts/ball.inc"\n#declare Wide = 1;\nBa^ll(Wide)\n')


def test_references_through_includes_and_open_texts(client: Client, three_texts: Three) -> None:
    document, position = three_texts

    def places(position: types.Position, declaration: bool) -> list[tuple[str, int, int]]:
        params = types.ReferenceParams(types.ReferenceContext(declaration), document, position)
        answer = client.wait(client.client.text_document_references_async(params))
        return sorted(
            (place.uri.rpartition("/")[2], place.range.start.line, place.range.start.character)
            for place in answer or []
        )

    assert places(position, True) == [("ball.inc", 1, 7), ("other.pov", 2, 0), ("scene.pov", 2, 0)]
    assert places(position, False) == [("other.pov", 2, 0), ("scene.pov", 2, 0)]
    # The include's own name of that kind ends with its file, and other.pov's is its own.
    assert places(types.Position(2, 6), True) == [("scene.pov", 1, 9), ("scene.pov", 2, 5)]


def test_rename_through_includes(client: Client, three_texts: Three) -> None:
    document, position = three_texts
    answer = client.wait(client.client.text_document_rename_async(types.RenameParams(document, position, "Globe")))
    assert answer is not None
    assert answer.changes is not None
    files = {uri.rpartition("/")[2]: len(edits) for uri, edits in answer.changes.items()}
    assert files == {"scene.pov": 1, "ball.inc": 1, "other.pov": 1}


def test_names_of_the_library_are_not_renamed(client: Client, tmp_path: Path) -> None:
    document, position = client.open(tmp_path / "library.pov", '#include "colors.inc"\nbackground { Re^d }\n')
    with pytest.raises(JsonRpcException, match=r"colors\.inc, which all scenes share"):
        client.wait(client.client.text_document_rename_async(types.RenameParams(document, position, "Rouge")))
    with pytest.raises(JsonRpcException, match="which all scenes share"):
        client.wait(client.client.text_document_prepare_rename_async(types.PrepareRenameParams(document, position)))


def test_document_symbols(client: Client, tmp_path: Path) -> None:
    document, _ = client.open(tmp_path / "l.pov", SCENE)
    answer = client.wait(client.client.text_document_document_symbol_async(types.DocumentSymbolParams(document)))
    assert answer is not None
    assert [(one.name, one.kind.name) for one in answer] == [
        ("Size", "Variable"),
        ("Ball", "Function"),
        ("sphere", "Object"),
    ]


def test_folding(client: Client, tmp_path: Path) -> None:
    text = "/* a\n b */\nunion {\n  box { 0, 1 }\n}\n#if (1)\n  box { 0, 1 }\n#else\n  box { 0, 1 }\n#end\n"
    document, _ = client.open(tmp_path / "m.pov", text)
    answer = client.wait(client.client.text_document_folding_range_async(types.FoldingRangeParams(document)))
    assert answer is not None
    assert [(fold.start_line, fold.end_line) for fold in answer] == [(0, 1), (2, 3), (5, 6), (7, 8)]


def test_semantic_tokens(client: Client, tmp_path: Path) -> None:
    document, _ = client.open(tmp_path / "n.pov", "#macro M(A)\n  A\n#end\nM(1)\n")
    answer = client.wait(client.client.text_document_semantic_tokens_full_async(types.SemanticTokensParams(document)))
    assert answer is not None
    provider = client.started.capabilities.semantic_tokens_provider
    assert provider is not None
    names = provider.legend.token_types
    rows = [tuple(answer.data[at : at + 5]) for at in range(0, len(answer.data), 5)]
    assert [(row[0], row[1], row[2], names[row[3]], row[4]) for row in rows] == [
        (0, 7, 1, "macro", 1),
        (0, 2, 1, "parameter", 1),
        (1, 2, 1, "parameter", 0),
        (2, 0, 1, "macro", 0),
    ]


def test_colours(client: Client, tmp_path: Path) -> None:
    text = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\nbackground { rgb <1, 0.2140, 0> }\n"
    document, _ = client.open(tmp_path / "o.pov", text)
    answer = client.wait(client.client.text_document_document_color_async(types.DocumentColorParams(document)))
    assert answer is not None
    (color,) = answer
    assert (color.range.start.character, color.range.end.character) == (17, 31)
    assert color.color.green == pytest.approx(0.5, abs=1e-3)
    params = types.ColorPresentationParams(document, types.Color(0.5, 0.0, 1.0, 1.0), color.range)
    (shown,) = client.wait(client.client.text_document_color_presentation_async(params)) or ()
    assert shown.label == "<0.214, 0, 1>"


def test_positions_count_utf16(client: Client, tmp_path: Path) -> None:
    text = "#declare A = 1; /* 🌍é */ sphere { A^, B }\n"
    document, position = client.open(tmp_path / "p.pov", text)
    position.character += 1
    answer = client.wait(client.client.text_document_hover_async(types.HoverParams(document, position)))
    assert answer is not None
    assert answer.range is not None
    assert answer.range.end.character == position.character
