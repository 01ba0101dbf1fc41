"""Compiled files on disk, so that the standard includes load in milliseconds.

A file is known by its content and path, and by the versions of Python and of all code that takes part in compiling.
What cannot be read back is compiled anew; entries are written under another name first, so that readers never see half
of one.
"""

from __future__ import annotations

import hashlib
import os
import sys
import tempfile
from functools import cache
from pathlib import Path
from typing import Final

from minipov.grammar.errors import SdlSyntaxError
from minipov.grammar.text import decode, is_utf8
from minipov.interpreter.compiler.program import Program
from minipov.interpreter.errors import SdlError
from platformdirs import user_cache_path

_LARGEST: Final = 4_000_000
"""Bytes of source beyond which a file is not kept: it is data, and changes with every run of what wrote it."""


def compiled(path: str, content: bytes) -> Program:
    """The code of a file.

    Raises:
        SdlError: the text is not SDL.
    """
    entry = _entry(path, content)
    program = _read(entry) if entry is not None else None
    if program is None:
        program = compile_text(path, content)
        if entry is not None:
            _write(entry, program)
    return program


def compile_text(path: str, content: bytes, *, recovering: bool = False) -> Program:
    """The code of a file, not looking at the cache; ``recovering`` goes on after mistakes."""
    # The grammar takes a while to load, and scenes that are known do not need it.
    from minipov.grammar.parser import parse_what_runs
    from minipov.interpreter.compiler.files import compile_file
    from minipov.interpreter.compiler.recovering import compile_recovering

    try:
        compile_tree = compile_recovering if recovering else compile_file
        return compile_tree(parse_what_runs(decode(content), path), utf8=content.isascii() or is_utf8(content))
    except SdlSyntaxError as error:
        raise SdlError(error.message, (error.path or path, error.line, error.column), error.hint) from None


def _entry(path: str, content: bytes) -> Path | None:
    folder = cache_folder()
    if folder is None or len(content) > _LARGEST:
        return None
    digest = hashlib.blake2b(content, digest_size=20, person=b"minipov")
    digest.update(f"\0{path}\0{_version()}".encode())
    return folder / f"{digest.hexdigest()}.code"


def cache_folder() -> Path | None:
    """Where compiled files are kept, if anywhere. ``MINIPOV_CACHE`` names another folder, empty for none."""
    given = os.environ.get("MINIPOV_CACHE")
    if given is not None:
        return Path(given) if given else None
    return user_cache_path("minipov") / "code"


@cache
def _version() -> str:
    """What the code of a file depends on besides its text: Python, and the sources of grammar and compiler."""
    import minipov.grammar
    import minipov.interpreter.compiler

    digest = hashlib.blake2b(sys.version.encode(), digest_size=12)
    for package in (minipov.grammar, minipov.interpreter.compiler):
        for source in sorted(Path(package.__path__[0]).iterdir()):
            if source.suffix in (".py", ".lark"):
                state = source.stat()
                digest.update(f"{source.name} {state.st_size} {state.st_mtime_ns}\0".encode())
    return digest.hexdigest()


def _read(entry: Path) -> Program | None:
    try:
        data = entry.read_bytes()
        check, body = data[:16], data[16:]
        if hashlib.blake2b(body, digest_size=16).digest() != check:
            return None
        return Program.restored(body)
    except (OSError, ValueError, EOFError, TypeError):
        return None


def _write(entry: Path, program: Program) -> None:
    try:
        entry.parent.mkdir(parents=True, exist_ok=True)
        body = program.dumped()
        handle, name = tempfile.mkstemp(dir=entry.parent, prefix=".new-")
        with os.fdopen(handle, "wb") as stream:
            stream.write(hashlib.blake2b(body, digest_size=16).digest() + body)
        os.replace(name, entry)
    except (OSError, ValueError):
        return
