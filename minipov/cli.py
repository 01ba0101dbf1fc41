"""The program: `minipov scene.pov +W640 +H480`, and the subcommands `check`, `diff` and `lsp`.

What a run does not need is not imported: `minipov --version` answers before Python has loaded NumPy.
"""

from __future__ import annotations

import gc
import importlib
import os
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NoReturn, cast

from minipov import __version__
from minipov.exit_status import INTERRUPTED, OK, SCENE_ERROR, USAGE_ERROR
from minipov.include_path import startup_ini
from minipov.interruption import interrupt_once
from minipov.options import UsageError, parse_command_line

SUBCOMMANDS = {"check": "minipov.check", "diff": "minipov.compare.command", "lsp": "minipov.editor.server.command"}
"""Modules whose ``main(arguments) -> int`` a first word calls."""


def entry() -> NoReturn:
    """Be the program. It ends at once, not waiting for a scene's threads nor taking its data apart."""
    status = main()
    for stream in (sys.stdout, sys.stderr):
        try:
            if not stream.closed:  # as the language server leaves its own
                stream.flush()
        except OSError:
            status = status or SCENE_ERROR
    if _subcommand(sys.argv[1:]) is not None:
        sys.exit(status)
    os._exit(status)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the program and return its exit status: 0, 1 for a mistake in the scene, 2 of usage, 130 interrupted."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    try:
        module = _subcommand(words)
        if module is not None:
            run = cast(Callable[[Sequence[str]], int], importlib.import_module(module).main)
            return run(words[1:])
        return _render(words)
    except UsageError as error:
        print(f"minipov: {error}", file=sys.stderr)
        return USAGE_ERROR
    except BrokenPipeError:
        return SCENE_ERROR
    except KeyboardInterrupt:
        return INTERRUPTED


def _subcommand(words: Sequence[str]) -> str | None:
    """The module that the first word calls; a scene of that name goes first."""
    return SUBCOMMANDS.get(words[0]) if words and not Path(words[0]).is_file() else None


def _render(words: Sequence[str]) -> int:
    interrupt_once()
    command = parse_command_line(words, startup_ini())
    if command.flag("Help") or not words:
        from minipov.option_help import help_text

        print(help_text())
        return OK if words else USAGE_ERROR
    if command.flag("Program_Version"):
        print(f"minipov {__version__}")
        return OK
    # A scene holds hardly any cycles: looking for them while it grows would only cost time.
    gc.disable()
    from minipov.job import run

    gc.enable()
    gc.freeze()
    gc.set_threshold(100_000, 20, 100)
    return run(command)


if __name__ == "__main__":
    entry()
