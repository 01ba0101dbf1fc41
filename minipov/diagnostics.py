"""How a mistake in a scene is shown: place, the line itself with a caret, what would fix it, who called.

::

    scene.pov:3:12: error: expected a colour
        pigment { rgbb 1 }
                  ^
    did you mean rgb?
    in macro Ball, called at scene.pov:9:1
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from minipov.interpreter.errors import Message, Place, SdlError


def describe(error: SdlError, sources: Mapping[str, bytes] | None = None) -> str:
    """Return all lines about ``error``; ``sources`` are texts that are not files, by name."""
    lines = [f"{_position(error.place)}error: {error.message}", *_pinpoint(error.place, sources or {})]
    if error.hint:
        lines.append(error.hint)
    lines += [f"in {what}, called at {_position(place).removesuffix(': ')}" for what, place in error.stack]
    return "\n".join(lines)


def describe_message(message: Message) -> str:
    """Return the line for a warning or a note; what ``#debug`` prints stands as it is."""
    if message.kind == "debug":
        return message.text
    return f"{_position(message.place)}{message.kind}: {message.text}"


def povray_lines(error: SdlError) -> str:
    """Return the lines by which programs recognise POV-Ray's parse errors."""
    file, line, _ = error.place
    where = f"File '{file}' line {line}: " if file else ""
    return f"{where}Parse Error: {error.message}\nFatal error in parser: Cannot parse input.\nRender failed"


def _position(place: Place) -> str:
    file, line, column = place
    return f"{file}:{line}:{column}: " if file else ""


def _pinpoint(place: Place, sources: Mapping[str, bytes]) -> list[str]:
    """The line of the source and a caret under the column; nothing where the source cannot be read."""
    file, line, column = place
    try:
        text = sources[file] if file in sources else Path(file).read_bytes()
        source = text.decode("utf-8", "replace").splitlines()[line - 1]
    except (OSError, IndexError, ValueError):
        return []
    before = source[: max(column - 1, 0)].expandtabs(4)
    return [f"    {source.expandtabs(4).rstrip()}", "    " + " " * len(before) + "^"] if line > 0 else []
