"""The TextMate grammar of the VS Code extension: `python -m minipov.editor.highlight.textmate FILE` writes it."""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from minipov.editor.highlight import words

_NAME = r"[A-Za-z_][A-Za-z0-9_]*"


def grammar() -> dict[str, Any]:
    """The grammar as JSON has it."""
    return {
        "$schema": "https://raw.githubusercontent.com/martinring/tmlanguage/master/tmlanguage.json",
        "name": "POV-Ray SDL",
        "scopeName": "source.povray",
        "patterns": [{"include": f"#{name}"} for name in _repository()],
        "repository": _repository(),
    }


def text() -> str:
    """The file."""
    return json.dumps(grammar(), indent=2) + "\n"


def _repository() -> dict[str, dict[str, Any]]:
    return {
        "line-comment": _match(r"//.*$", "comment.line.double-slash"),
        "comment": {
            "name": "comment.block.povray",
            "begin": r"/\*",
            "end": r"\*/",
            "patterns": [{"include": "#comment"}],
        },
        "string": {
            "name": "string.quoted.double.povray",
            "begin": '"',
            "end": '"',
            "patterns": [_match(r"\\(?:u[0-9A-Fa-f]{4}|.)", "constant.character.escape")],
        },
        "macro": _declaration("macro", "entity.name.function"),
        "declare": _declaration("declare|local", "variable.other.declaration"),
        "control": _directive(words.CONTROL, "keyword.control"),
        "directive": _directive(words.DECLARING, "keyword.control.directive"),
        "constant": _match(words.alternatives(words.CONSTANTS), "constant.language"),
        "function": _match(words.alternatives(words.FUNCTIONS), "support.function"),
        "color": _match(words.alternatives(words.COLORS), "storage.type.color"),
        "block": _match(words.alternatives(words.BLOCK_WORDS) + r"(?=\s*(?:\{|$|//|/\*))", "entity.name.type.block"),
        "word": _match(words.alternatives(words.BLOCK_WORDS | words.OTHER_WORDS), "support.type.property-name"),
        "call": _match(rf"\b{_NAME}(?=\s*\()", "entity.name.function.call"),
        "name": _match(rf"\b{_NAME}\b", "variable.other"),
        "number": _match(r"(?:\b\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", "constant.numeric"),
        "operator": _match(r"<=|>=|!=|[-+*/=<>?!&|]", "keyword.operator"),
        "punctuation": _match(r"[,;:.]", "punctuation.separator"),
    }


def _match(pattern: str, scope: str) -> dict[str, Any]:
    return {"match": pattern, "name": f"{scope}.povray"}


def _directive(names: Sequence[str] | frozenset[str] | set[str], scope: str) -> dict[str, Any]:
    return _match(rf"#\s*(?:{'|'.join(sorted(names))})\b", scope)


def _declaration(names: str, scope: str) -> dict[str, Any]:
    return {
        "match": rf"(#\s*(?:{names}))\s+({_NAME})",
        "captures": {
            "1": {"name": "keyword.control.directive.povray"},
            "2": {"name": f"{scope}.povray"},
        },
    }


def main() -> None:
    """Write the grammar to the file that is named."""
    Path(sys.argv[1]).write_text(text(), encoding="utf-8")


if __name__ == "__main__":
    main()
