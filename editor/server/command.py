"""`minipov lsp`: the language server on standard input and output."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from minipov.include_path import library_folders

USAGE = """\
usage: minipov lsp [--library-path FOLDER ...]

The language server for SDL, for editors to start: it speaks the Language Server Protocol on standard input and output.
Includes are looked for beside the text, in the folders given, in POVINC and where POV-Ray is installed.
"""


def main(arguments: Sequence[str]) -> int:
    """Serve until the client goes away; exit status 2 for a usage error or a missing library."""
    words = list(arguments)
    folders: list[Path] = []
    while words:
        word = words.pop(0)
        if word in {"-h", "--help"}:
            print(USAGE, end="")
            return 0
        if word == "--library-path" and words:
            folders.append(Path(words.pop(0)))
        elif word != "--stdio":
            print(f"minipov lsp: cannot understand '{word}'\n\n{USAGE}", file=sys.stderr, end="")
            return 2
    try:
        from minipov.editor.server.language_server import language_server
    except ModuleNotFoundError as error:
        if error.name not in {"pygls", "lsprotocol"}:
            raise
        print("minipov lsp needs pygls: pip install 'minipov[editor]'", file=sys.stderr)
        return 2
    language_server((*folders, *library_folders())).start_io()
    return 0
