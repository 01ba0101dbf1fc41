"""A compiled file, as it is kept on disk and as it is run."""

from __future__ import annotations

import marshal
from collections.abc import Iterator
from dataclasses import dataclass
from types import CodeType
from typing import Any

from minipov.interpreter.compiler.constants import revive

ENTRY = "file_items"
"""The Python name of the function that does what stands in a file outside its macros."""


@dataclass(frozen=True, slots=True)
class Program:
    """Run ``code`` in a namespace with the symbols (``s_NAME``) and constants (``k0`` ...), then call ``entry``."""

    path: str
    code: CodeType
    symbols: tuple[str, ...]
    constants: tuple[Any, ...]
    entry: str = ENTRY

    def revived(self) -> Iterator[Any]:
        """The values of the constants."""
        return map(revive, self.constants)

    def dumped(self) -> bytes:
        """As bytes, for the disk."""
        return marshal.dumps((self.path, self.code, self.symbols, self.constants))

    @staticmethod
    def restored(data: bytes) -> Program:
        """From bytes.

        Raises:
            ValueError, EOFError, TypeError: the bytes are not what `dumped` made.
        """
        path, code, symbols, constants = marshal.loads(data)
        if not isinstance(code, CodeType):
            raise ValueError("not a compiled file")
        return Program(path, code, symbols, constants)
