"""SDL for Pygments: ``pygmentize -l sdl scene.pov``."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

from minipov.editor.highlight import words
from pygments.lexer import RegexLexer, bygroups
from pygments.token import Comment, Keyword, Name, Number, Operator, Punctuation, String, Whitespace

_NAME = r"[A-Za-z_]\w*"
_groups: Callable[..., Any] = bygroups
"""Pygments' function, which has no type of its own."""


class SdlLexer(RegexLexer):
    """The scene description language of POV-Ray, as minipov's keyword table has it."""

    name = "SDL"
    aliases: ClassVar[list[str]] = ["sdl", "minipov"]
    filenames: ClassVar[list[str]] = ["*.pov", "*.inc"]
    mimetypes: ClassVar[list[str]] = ["text/x-povray"]
    url = "https://www.povray.org/documentation/3.7.0/"

    tokens: ClassVar[dict[str, list[Any]]] = {
        "root": [
            (r"[\s\ufeff\x1a\0]+", Whitespace),
            (r"//.*", Comment.Single),
            (r"/\*", Comment.Multiline, "comment"),
            (r'"(?:[^"\\]|\\.)*"', String.Double),
            (rf"(#\s*)(macro)(\s+)({_NAME})",
             _groups(Comment.Preproc, Keyword.Declaration, Whitespace, Name.Function)),
            (rf"(#\s*)(declare|local)(\s+)({_NAME})",
             _groups(Comment.Preproc, Keyword.Declaration, Whitespace, Name.Variable)),
            (rf"(#\s*)({words.alternatives(words.CONTROL)})", _groups(Comment.Preproc, Keyword)),
            (rf"(#\s*)({words.alternatives(words.DECLARING)})", _groups(Comment.Preproc, Keyword.Declaration)),
            (r"#", Comment.Preproc),
            (words.alternatives(words.CONSTANTS), Keyword.Constant),
            (words.alternatives(words.FUNCTIONS), Name.Builtin),
            (words.alternatives(words.COLORS), Keyword.Type),
            (words.alternatives(words.BLOCK_WORDS), Name.Class),
            (words.alternatives(words.OTHER_WORDS), Name.Attribute),
            (rf"{_NAME}(?=\s*\()", Name.Function),
            (_NAME, Name),
            (r"(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", Number),
            (r"<=|>=|!=|[-+*/=<>?!&|]", Operator),
            (r"[][(){},;:.]", Punctuation),
        ],
        "comment": [
            (r"/\*", Comment.Multiline, "#push"),
            (r"\*/", Comment.Multiline, "#pop"),
            (r"[^/*]+|[/*]", Comment.Multiline),
        ],
    }  # fmt: skip
