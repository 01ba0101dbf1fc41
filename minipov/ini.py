"""INI files: ``file.ini`` or ``file.ini[Section]`` as an argument.

::

    ; a comment
    Width = 640
    Library_Path="/usr/share/my includes"
    +A0.1 -D                  ; switches, several to a line
    [Low]                     ; read when asked for: file.ini[Low]
    Width = 160
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

_STATEMENT = re.compile(r"\s*([A-Za-z_][A-Za-z_0-9]*)\s*=\s*(.*)", re.S)
_SECTION = re.compile(r"\s*\[\s*(.*?)\s*\]\s*$")
_ARGUMENT_SECTION = re.compile(r"(.+)\[([^\]]*)\]$", re.S)
_WORD = re.compile(r"""(?:"[^"]*"|'[^']*'|\S)+""")


@dataclass(frozen=True, slots=True)
class Statement:
    """``key=value``, or a word (a switch, a file name) with an empty ``key``; ``line`` is counted from 1."""

    key: str
    value: str
    line: int


def split_statement(text: str) -> tuple[str, str] | None:
    """Split ``Key=value``, taking off quotes around the value; None for anything else."""
    match = _STATEMENT.fullmatch(text)
    return None if match is None else (match.group(1), unquoted(match.group(2).strip()))


def split_section(argument: str) -> tuple[str, str]:
    """Split ``file.ini[Section]``; the section is "" where none is named."""
    match = _ARGUMENT_SECTION.fullmatch(argument)
    return (argument, "") if match is None else (match.group(1), match.group(2).strip())


def read_ini(path: Path, section: str = "") -> Iterator[Statement]:
    """Yield the statements before the first section and those of ``section``, in their order.

    Raises:
        OSError: the file cannot be read.
    """
    reading = True
    for number, line in enumerate(path.read_text("utf-8", "replace").splitlines(), 1):
        text = _without_comment(line)
        heading = _SECTION.fullmatch(text)
        if heading is not None:
            reading = heading.group(1).lower() == section.lower() and section != ""
        elif reading:
            yield from _statements(text, number)


def unquoted(text: str) -> str:
    """Take off one pair of quotes that encloses the whole text."""
    if len(text) >= 2 and text[0] == text[-1] and text[0] in "\"'":
        return text[1:-1]
    return text


def _statements(text: str, line: int) -> Iterator[Statement]:
    statement = split_statement(text)
    if statement is not None:
        yield Statement(*statement, line)
        return
    for word in _WORD.findall(text):
        yield Statement("", word.replace('"', "").replace("'", ""), line)


def _without_comment(line: str) -> str:
    """Cut the line at the first semicolon outside quotes."""
    quote = ""
    for position, character in enumerate(line):
        if quote:
            quote = "" if character == quote else quote
        elif character == ";":
            return line[:position]
        elif character in "\"'":
            quote = character
    return line
