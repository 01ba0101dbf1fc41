"""What the user sees while a scene renders: messages, errors, POV-Ray's headings, progress.

Everything goes to standard error. On a terminal there is a progress bar; in a pipe only warnings and errors are
printed, unless ``+V`` asks for the lines by which other programs follow POV-Ray:
``==== [Rendering...] ====`` and ``Rendered 1024 of 76800 pixels (1%)``.
"""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Literal, TextIO, TypeAlias

from minipov.diagnostics import describe, describe_message, povray_lines
from minipov.interpreter.errors import Message, SdlError
from minipov.options import CommandLine

Stream: TypeAlias = Literal["Debug", "Fatal", "Render", "Statistic", "Warning"]
_HEADING_WIDTH = 76


class Console:
    """The message streams of one run; ``+GDfile`` and its like write them to files as well."""

    def __init__(self, command: CommandLine, out: TextIO | None = None) -> None:
        self._command = command
        self._out = out or sys.stderr
        self._is_terminal = self._out.isatty()
        self._fresh: set[str] = set()
        self.verbose = command.flag("Verbose") and command.flag("All_Console")

    def message(self, message: Message) -> None:
        """Print what the scene or the interpreter says."""
        stream: Stream = "Debug" if message.kind == "debug" else "Warning"
        if stream == "Debug" or self._command.integer("Warning_Level") > 0:
            self.say(stream, describe_message(message))

    def warn(self, text: str) -> None:
        """Print a warning that has no place in the scene."""
        self.message(Message("warning", text))

    def scene_error(self, error: SdlError, sources: Mapping[str, bytes]) -> None:
        """Print a mistake in the scene; for programs also in the words of POV-Ray."""
        self.say("Fatal", describe(error, sources))
        if not self._is_terminal:
            self.say("Fatal", povray_lines(error))

    def error(self, text: str) -> None:
        """Print why the run fails."""
        self.say("Fatal", f"error: {text}")

    def heading(self, title: str) -> None:
        """Print ``==== [Parsing...] ====`` in verbose runs."""
        if self.verbose:
            self.say("Render", f"==== [{title}] ".ljust(_HEADING_WIDTH, "="))

    def say(self, stream: Stream, text: str) -> None:
        """Print to one of POV-Ray's streams, as far as it is switched on, and to its files."""
        for key in (f"{stream}_File", "All_File"):
            name = self._command.text(key)
            if name:
                self._append(name, text)
        if self._command.flag("All_Console") and self._command.flag(f"{stream}_Console"):
            self._print(text)

    @contextlib.contextmanager
    def progress(self, total: int) -> Iterator[Callable[[float], None]]:
        """Give a function that takes the finished share of ``total`` pixels."""
        if self.verbose:
            yield self._count_pixels(total)
            self._print("")
        elif self._is_terminal and self._command.flag("All_Console"):
            with progress_bar(self._out, total) as advance:
                yield advance
        else:
            yield lambda share: None

    def _count_pixels(self, total: int) -> Callable[[float], None]:
        said = -1

        def count(share: float) -> None:
            nonlocal said
            done = round(share * total)
            if done != said:
                said = done
                self._print(f"Rendered {done} of {total} pixels ({100 * done // total}%)", end="\r")

        return count

    def _append(self, name: str, text: str) -> None:
        """Add to a file, which the first text of a run empties unless ``+GP`` says otherwise."""
        mode = "a" if name in self._fresh or self._command.flag("Append_File") else "w"
        self._fresh.add(name)
        try:
            with Path(name).open(mode, encoding="utf-8") as file:
                file.write(text + "\n")
        except OSError as error:
            self._print(f"error: cannot write {name}: {error.strerror}")

    def _print(self, text: str, end: str = "\n") -> None:
        print(text, end=end, file=self._out, flush=True)


@contextlib.contextmanager
def progress_bar(out: TextIO, total: int) -> Iterator[Callable[[float], None]]:
    """Show a bar on a terminal, taken away at the end; the function given takes the finished share of ``total``."""
    # Rich takes a while to load, which small pictures should not wait for.
    from rich.console import Console as Terminal
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        TextColumn,
        TimeElapsedColumn,
        TimeRemainingColumn,
    )

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn())
    times = (TimeElapsedColumn(), TimeRemainingColumn())
    with Progress(*columns, *times, console=Terminal(file=out), transient=True) as bar:
        task = bar.add_task("Rendering", total=total)
        yield lambda share: bar.update(task, completed=int(share * total))
