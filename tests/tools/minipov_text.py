"""Load a scene with minipov for what it says, not for a picture."""

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from minipov.interpreter import Message, Messages, SdlError, load

from minipov.frames import frames
from minipov.options import parse_command_line
from minipov.pipeline import load_options


@dataclass(frozen=True, slots=True)
class Said:
    """The lines of the debug stream, the warnings, and the error that ended the run, if one did."""

    debug: tuple[str, ...]
    warnings: tuple[Message, ...]
    error: SdlError | None


def run_minipov(scene: Path, work: Path, switches: Sequence[str] = ()) -> Said:
    """Load ``scene`` in the folder ``work``, where its files go, as if one pixel were to be rendered."""
    command = parse_command_line([f"+I{scene}", f"+L{scene.parent}", "+W1", "+H1", *switches])
    messages = Messages()
    error = None
    before = Path.cwd()
    os.chdir(work)
    try:
        load(scene, load_options(command, frames(command)[0], {}), messages)
    except SdlError as raised:
        error = raised
    finally:
        os.chdir(before)
    lines = "\n".join(message.text for message in messages.all if message.kind == "debug").splitlines()
    debug = tuple(line.rstrip() for line in lines)
    return Said(debug, tuple(message for message in messages.all if message.kind == "warning"), error)
