"""Colouring by words: the Pygments lexer on every file, the TextMate grammar up to date."""

from __future__ import annotations

from importlib.metadata import entry_points
from pathlib import Path

import pytest
from corpus import FILES
from minipov.editor.highlight import textmate, words
from minipov.editor.highlight.pygments_lexer import SdlLexer
from minipov.grammar.keywords import DIRECTIVES, KEYWORDS
from minipov.grammar.text import decode
from pygments.token import Comment, Error, Keyword, Name, Number, Token

ROOT = Path(__file__).parents[2]


@pytest.mark.parametrize("folder", sorted({f.parent for f in FILES}), ids=lambda f: f.name)
def test_no_file_has_an_error_token(folder: object) -> None:
    for file in (f for f in FILES if f.parent == folder and f.stat().st_size < 100_000):
        text = decode(file.read_bytes())
        tokens = list(SdlLexer(stripnl=False, ensurenl=False).get_tokens(text))
        if file.name != "__empty.pov":
            assert [value for kind, value in tokens if kind is Error] == [], file
        assert "".join(value for _, value in tokens) == text.replace("\r\n", "\n").replace("\r", "\n").lstrip("\ufeff")


def test_kinds() -> None:
    text = "#declare A = sphere { x, sin(1) pigment { rgb B } /* a /* b */ c */ M(3) }"
    kinds = {value: kind for kind, value in SdlLexer().get_tokens(text)}
    assert kinds["declare"] is Keyword.Declaration
    assert kinds["A"] is Name.Variable
    assert kinds["sphere"] is Name.Class
    assert kinds["x"] is Keyword.Constant
    assert kinds["sin"] is Name.Builtin
    assert kinds["rgb"] is Keyword.Type
    assert kinds["B"] is Name
    assert kinds[" c "] is Comment.Multiline
    assert kinds["M"] is Name.Function
    assert kinds["3"] is Number
    assert Token not in kinds.values()


def test_the_lexer_is_announced() -> None:
    found = entry_points(group="pygments.lexers", name="sdl")
    assert [point.load() for point in found] == [SdlLexer], "install the package again"


def test_every_keyword_has_one_colour() -> None:
    groups = [words.CONSTANTS, words.FUNCTIONS, words.COLORS, words.BLOCK_WORDS, words.OTHER_WORDS]
    assert set().union(*groups) == set(KEYWORDS)
    assert sum(map(len, groups)) == len(KEYWORDS)
    assert set(words.CONTROL | words.DECLARING) == set(DIRECTIVES)
    assert words.CONTROL.issubset(DIRECTIVES)


def test_the_textmate_grammar_is_fresh() -> None:
    file = ROOT / "editor/vscode/syntaxes/povray.tmLanguage.json"
    assert file.read_text(encoding="utf-8") == textmate.text(), (
        f"run python -m minipov.editor.highlight.textmate {file}"
    )
