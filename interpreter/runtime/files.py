"""SDL: ``#fopen H "data.txt" read``, ``#read (H, A, B)``, ``#write (H, "x = ", X, uint8 7)``, ``#fclose H``.

A data file holds floats, vectors of floats and quoted strings, with a comma after every item.
"""

from __future__ import annotations

import re
import struct
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, BinaryIO, Final

from minipov.grammar.text import decode
from minipov.interpreter.errors import SdlError
from minipov.interpreter.values import Vector, kind_of, terms

_BINARY: Final = {
    "uint8": (">B", 0, 2**8 - 1),
    "sint8": (">b", -(2**7), 2**7 - 1),
    "uint16be": (">H", 0, 2**16 - 1),
    "uint16le": ("<H", 0, 2**16 - 1),
    "sint16be": (">h", -(2**15), 2**15 - 1),
    "sint16le": ("<h", -(2**15), 2**15 - 1),
    "sint32be": (">i", -(2**31), 2**31 - 1),
    "sint32le": ("<i", -(2**31), 2**31 - 1),
}
BINARY_WORDS: Final = frozenset(_BINARY)

_FLOAT: Final = r"[+-]?\s*(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_ITEM: Final = re.compile(
    rf"""\s*(?:(?P<vector><(?P<terms>[^>]*)>)|(?P<float>{_FLOAT})|"(?P<string>(?:[^"\\]|\\.)*)")\s*""",
    re.VERBOSE,
)
_LONGEST_BLANK: Final = 4096
_ESCAPES: Final = {"n": "\n", "t": "\t", "r": "\r", "a": "\a", "b": "\b", "f": "\f", "v": "\v", "0": "\0"}


class Reader:
    """A data file opened for reading."""

    sdl_kind = "file handle"

    def __init__(self, name: str, content: bytes) -> None:
        self.name = name
        self._text = decode(content)
        self._at = 0
        self.at_end = False
        """Whether a reading has met the end of the file (a comma before it does not count as the end)."""

    def read(self) -> Any:
        """The next item; None if the file has ended.

        Raises:
            SdlError: something else stands there.
        """
        if len(self._text) - self._at < _LONGEST_BLANK and not self._text[self._at :].strip():
            self.at_end = True
        if self.at_end:
            return None
        match = _ITEM.match(self._text, self._at)
        if match is None:
            line = self._text.count("\n", 0, self._at) + 1
            found = self._text[self._at : self._at + 20].strip()
            raise SdlError(f"{self.name}:{line}: expected a number, vector or string, found {found!r}")
        self._at = match.end()
        self._separator()
        if match["float"] is not None:
            return float(re.sub(r"\s", "", match["float"]))
        if match["string"] is not None:
            return re.sub(r"\\(.)", lambda m: _ESCAPES.get(m[1], m[1]), match["string"])
        numbers = re.findall(_FLOAT, match["terms"])
        if not 2 <= len(numbers) <= 5:
            raise SdlError(f"{self.name}: a vector of {len(numbers)} terms")
        return Vector(float(re.sub(r"\s", "", number)) for number in numbers)

    def _separator(self) -> None:
        """The comma after an item. Where another item stands instead, that is lost, as in POV-Ray."""
        if self._text.startswith(",", self._at):
            self._at += 1
        elif other := _ITEM.match(self._text, self._at):
            self._at = other.end()
        elif self._at == len(self._text):
            self.at_end = True

    def close(self) -> None:
        """Nothing is held open."""


class Writer:
    """A data file opened for writing."""

    sdl_kind = "file handle"

    def __init__(self, name: str, stream: BinaryIO) -> None:
        self.name = name
        self._stream = stream

    def write(self, value: Any, binary: str | None) -> None:
        """One item: as text, or packed as a binary word."""
        if binary is not None:
            self._stream.write(b"".join(_packed(term, binary) for term in terms(value)))
        elif isinstance(value, str):
            self._stream.write(value.encode("utf-8", "replace"))
        elif isinstance(value, Vector):
            self._stream.write(f"<{','.join(f'{term:g}' for term in value)}> ".encode())
        elif isinstance(value, float | int):
            self._stream.write(f"{value:g}".encode())
        else:
            raise SdlError(f"#write takes numbers, vectors and strings, not {kind_of(value)}")

    def close(self) -> None:
        """Put everything on disk."""
        self._stream.close()


def _packed(value: float, word: str) -> bytes:
    layout, least, most = _BINARY[word]
    rounded = int(value + 0.5) if value >= 0 else -int(0.5 - value)
    return struct.pack(layout, max(least, min(most, rounded)))


class Files:
    """The files that a scene has opened. Writing is allowed below ``writable`` folders only."""

    def __init__(self, find: Callable[[str, tuple[str, ...]], Path | None], writable: tuple[Path, ...] | None) -> None:
        self._find = find
        self._writable = (Path.cwd(), Path(tempfile.gettempdir())) if writable is None else writable
        self._open: list[Reader | Writer] = []

    def open(self, name: str, mode: str, read: Callable[[Path], bytes]) -> Reader | Writer:
        """``#fopen``; ``mode`` is ``read``, ``write`` or ``append``."""
        if not isinstance(name, str):
            raise SdlError(f"a file name is a string, not {kind_of(name)}")
        try:
            handle = self._reader(name, read) if mode == "read" else self._writer(name, mode)
        except OSError as error:
            raise SdlError(f"cannot open '{name}': {error.strerror or error}") from None
        self._open.append(handle)
        return handle

    def _reader(self, name: str, read: Callable[[Path], bytes]) -> Reader:
        path = self._find(name, ())
        if path is None:
            raise SdlError(f"cannot find file '{name}'")
        return Reader(name, read(path))

    def _writer(self, name: str, mode: str) -> Writer:
        path = Path(name)
        target = path.resolve()
        if not any(target.is_relative_to(folder.resolve()) for folder in self._writable):
            allowed = ", ".join(map(str, self._writable))
            raise SdlError(f"the scene may not write to '{name}'", hint=f"allowed folders: {allowed}")
        return Writer(name, path.open("ab" if mode == "append" else "wb"))

    def close(self, handle: Reader | Writer) -> None:
        """``#fclose``."""
        handle.close()
        self._open.remove(handle)

    def close_all(self) -> None:
        """At the end of the scene."""
        for handle in self._open:
            handle.close()
        self._open.clear()
