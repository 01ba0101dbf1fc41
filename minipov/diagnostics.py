"""How mistakes and warnings are worded for people, and for the programs that know POV-Ray's wording."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from minipov.grammar.text import decode
from minipov.interpreter.errors import Message, SdlError, format_error, where


def describe(error: SdlError, sources: Mapping[str, bytes]) -> str:
    """Return all lines about ``error``; ``sources`` are texts that are not files, by name."""
    file = error.place[0]
    try:
        content = sources[file] if file in sources else Path(file).read_bytes()
    except (OSError, ValueError):
        content = b""
    return format_error(error, {file: decode(content)})


def describe_message(message: Message) -> str:
    """Return the line for a warning or a note; what ``#debug`` prints stands as it is."""
    return message.text if message.kind == "debug" else f"{where(message.place)}{message.kind}: {message.text}"


def not_rendered(feature: str, place: str) -> str:
    """Return the warning about what the tracer leaves out; ``place`` is empty where it is not known."""
    return f"{feature}: not rendered yet" + (f" ({place})" if place else "")


def povray_lines(error: SdlError) -> str:
    """Return the lines by which programs recognise POV-Ray's parse errors."""
    file, line, _ = error.place
    place = f"File '{file}' line {line}: " if file else ""
    return f"{place}Parse Error: {error.message}\nFatal error in parser: Cannot parse input.\nRender failed"
