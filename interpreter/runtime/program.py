"""A running scene: it loads compiled files, gives them the names that they use, and keeps what directives change."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from minipov.grammar.text import decode
from minipov.interpreter.arrays import same_kind
from minipov.interpreter.constructs.default import set_version
from minipov.interpreter.context import Context
from minipov.interpreter.errors import Place, SdlError
from minipov.interpreter.runtime.blocks import Blocks
from minipov.interpreter.runtime.files import Files, Reader, Writer
from minipov.interpreter.runtime.names import Names, Symbol, Undeclared
from minipov.interpreter.runtime.places import MARK, current_place
from minipov.interpreter.runtime.search import INCLUDE_EXTENSIONS, FileSearch
from minipov.interpreter.runtime.streams import DebugStream, halted, warning
from minipov.interpreter.runtime.strings import now, text
from minipov.interpreter.values import kind_of

Loader = Callable[[str, bytes], Any]
"""Compiles a file's content, or takes it from the cache: gives a `compiler.files.Program`."""

MOST_INCLUDES = 200
NEWEST = 3.8
REPORTED_VERSION = 3.7
"""What the variable ``version`` reads in a scene that has not set it."""


class Running:
    """One run of a scene."""

    def __init__(self, context: Context, search: FileSearch, load: Loader) -> None:
        self.context = context
        self.search = search
        self.load = load
        self.names = Names()
        self.blocks = Blocks(context)
        self.random: list[int] = []
        self.debug = DebugStream(context.messages)
        self.files = Files(search.find, context.options.writable)
        self.sources: dict[str, str] = {}
        self.depth = 0
        self._loaded: dict[str, tuple[bytes, Callable[[], None]]] = {}
        self.input_file_name = ""
        self.library: dict[str, Any] = {}
        for name, value in context.options.declares.items():
            self.names[name].c.v = value if isinstance(value, str) else float(value)

    # --- files ---

    def run(self, name: str, content: bytes) -> None:
        """Do what a file says."""
        known = self._loaded.get(name)
        if known is None or known[0] != content:
            known = self._loaded[name] = (content, self._bound(name, content))
        known[1]()

    def _bound(self, name: str, content: bytes) -> Callable[[], None]:
        self.sources[name] = decode(content)
        return self.bound(name, self.load(name, content))

    def bound(self, name: str, program: Any) -> Callable[[], None]:
        """A compiled file as a function that runs it."""
        namespace = {**self.library, MARK: name}
        namespace.update((f"s_{symbol}", self.names[symbol]) for symbol in program.symbols)
        namespace.update((f"k{number}", value) for number, value in enumerate(program.revived()))
        exec(program.code, namespace)
        function: Callable[[], None] = namespace[program.entry]
        return function

    def include(self, file: Any, place: Place) -> None:
        """``#include "file"``."""
        path, content = self.included(file, place)
        self.depth += 1
        if self.depth > MOST_INCLUDES:
            raise SdlError(f"files include each other {MOST_INCLUDES} deep", place)
        self.search.beside.append(path.parent)
        self.run(str(path), content)
        self.search.beside.pop()
        self.depth -= 1

    def included(self, file: Any, place: Place) -> tuple[Path, bytes]:
        """The path and content of an include file."""
        path = self.search.find(text(file), INCLUDE_EXTENSIONS)
        if path is None:
            raise SdlError(f"cannot find the file '{file}'", place, hint=self.search.hint(file))
        try:
            return path, self.search.read(path)
        except OSError as error:
            raise SdlError(f"cannot read '{path}': {error.strerror or error}", place) from None

    # --- messages ---

    def warn(self, message: str) -> None:
        """Warn about what the program does at this moment."""
        self.context.messages.warn(message, current_place())

    def print_debug(self, message: Any, place: Place) -> None:
        """``#debug``."""
        self.debug.write(message, place)

    def print_warning(self, message: Any, place: Place) -> None:
        """``#warning``."""
        self.context.messages.warn(warning(message), place)

    def print_error(self, message: Any, place: Place) -> None:
        """``#error``."""
        error = halted(message)
        error.place = place
        raise error

    def obsolete(self, old: str, new: str) -> None:
        """A directive of former days."""
        self.context.messages.warn_once(old, f"{old} is obsolete, use {new}", current_place())

    def obsolete_setting(self, name: str, value: float) -> None:
        """``#max_trace_level``, ``#max_intersections``."""
        self.obsolete(f"#{name}", "global_settings")
        if name == "max_trace_level":
            from minipov.tracer.node import replace

            settings = self.context.scene.settings
            self.context.scene.settings = replace(settings, max_trace_level=int(value))

    # --- state ---

    def set_version(self, value: Any, place: Place) -> None:
        """``#version``."""
        if not isinstance(value, float | int):
            raise SdlError("#version takes a number", place)
        number = float(value)
        if number >= 10:
            number /= 100
        if number > NEWEST + 1e-6:
            raise SdlError(
                f"#version {number:g} is newer than this program knows", place, hint=f"up to {NEWEST} is known"
            )
        set_version(self.context, number)

    def characters(self, text: str, blanked: str) -> str:
        """A string with characters beyond ASCII: as ``blanked`` unless the scene says how it writes them."""
        if self.context.scene.charset != "ascii" or self.context.version >= 3.8:
            return text
        self.context.messages.warn_once(
            "charset", "characters beyond ASCII are read as blanks: global_settings { charset utf8 }", current_place()
        )
        return blanked

    def variable(self, name: str) -> Any:
        """A keyword that is a value only the running program knows."""
        options = self.context.options
        match name:
            case "version":
                return self.context.version if self.context.version_was_set else REPORTED_VERSION
            case "now":
                return now()
            case "image_width":
                return float(options.width)
            case "image_height":
                return float(options.height)
            case "input_file_name":
                return self.input_file_name
        value = getattr(options, name, None)
        if value is None:
            raise SdlError(f"'{name}' is not known here")
        return float(value)

    # --- data files ---

    def open_file(self, symbol: Symbol, name: Any, mode: str, place: Place) -> None:
        """``#fopen``."""
        if symbol.declared:
            raise SdlError(f"'{symbol.name}' is declared already", place, "the name of a file handle must be new")
        symbol.fix(self.files.open(name, mode, self.search.read))

    def close_file(self, symbol: Symbol) -> None:
        """``#fclose``; nothing is to do where `end_read` has closed the file already."""
        if not symbol.declared:
            return
        self.files.close(self._handle(symbol, Reader | Writer))
        symbol.undefine()

    def _handle(self, symbol: Symbol, kind: Any) -> Any:
        handle = symbol.c.v
        if not isinstance(handle, kind):
            use = "reading" if kind is Reader else "writing" if kind is Writer else "reading or writing"
            raise SdlError(f"'{symbol.name}' is no file opened for {use}")
        return handle

    def read_file(self, symbol: Symbol) -> Any:
        """One item of ``#read``; None when the file has ended."""
        return self._handle(symbol, Reader).read()

    def check_kind(self, cell: Any, value: Any) -> None:
        """``#read`` into a variable keeps its type."""
        if not isinstance(cell, Undeclared) and not same_kind(cell.v, value):
            raise SdlError(f"#read: the variable is {kind_of(cell.v)}, but the file has {kind_of(value)}")

    def end_read(self, symbol: Symbol) -> None:
        """The end of ``#read``: at the end of the file the handle is gone."""
        handle = self._handle(symbol, Reader)
        if handle.at_end:
            self.files.close(handle)
            symbol.undefine()

    def write_file(self, symbol: Symbol, value: Any, binary: str | None) -> None:
        """One item of ``#write``."""
        self._handle(symbol, Writer).write(value, binary)

    def find_file(self, name: str, extensions: tuple[str, ...]) -> Path | None:
        """Search a file as ``#include`` does."""
        return self.search.find(name, extensions)
