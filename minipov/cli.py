"""The program: `minipov scene.pov +W640 +H480`, and the subcommands `diff`, `check` and `lsp`."""

from __future__ import annotations

import importlib
import importlib.util
import signal
import sys
from collections.abc import Callable, Sequence
from importlib.metadata import version
from pathlib import Path
from typing import cast

from minipov.console import Console
from minipov.include_path import startup_ini
from minipov.job import INTERRUPTED, USAGE_ERROR, run
from minipov.option_help import help_text
from minipov.option_table import OPTIONS
from minipov.options import CommandLine, UsageError, parse_command_line

SUBCOMMANDS = {"diff": "minipov.compare.command"}
"""Modules whose ``main(arguments) -> int`` a first word calls."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the program and return its exit status: 0, 1 for a mistake in the scene, 2 of usage, 130 interrupted."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    try:
        if words and words[0] in SUBCOMMANDS and not Path(words[0]).is_file():
            subcommand = cast(Callable[[Sequence[str]], int], importlib.import_module(SUBCOMMANDS[words[0]]).main)
            return subcommand(words[1:])
        return _render(words)
    except UsageError as error:
        print(f"minipov: {error}", file=sys.stderr)
        return USAGE_ERROR
    except BrokenPipeError:
        return 1
    except KeyboardInterrupt:
        return INTERRUPTED


def _render(words: Sequence[str]) -> int:
    signal.signal(signal.SIGINT, signal.default_int_handler)
    command = parse_command_line(words, startup_ini())
    if command.flag("Help") or not words:
        print(help_text())
        return 0 if words else USAGE_ERROR
    if command.flag("Program_Version"):
        print(f"minipov {version('minipov')}")
        return 0
    console = Console(command)
    for warning in command.warnings:
        console.warn(warning)
    if command.text("Create_Ini"):
        _write_ini(command)
    return run(command, console)


def _write_ini(command: CommandLine) -> None:
    """Write the options that were set, in a form that can be read again."""
    lines = [f"{option.key}={command.values[option.key]}" for option in OPTIONS if option.key in command.given]
    lines = [line for line in lines if not line.startswith(("Library_Path=", "Declare=", "Create_Ini="))]
    lines += [f'Library_Path="{folder}"' for folder in command.library_paths]
    lines += [f"Declare={name}={value}" for name, value in command.declares.items()]
    path = Path(command.text("Create_Ini"))
    try:
        path.write_text("\n".join(lines) + "\n")
    except OSError as error:
        raise UsageError(f"cannot write {path}: {error.strerror}") from error


if __name__ == "__main__":
    sys.exit(main())
