"""The text of an SDL file: its bytes as characters."""

from __future__ import annotations


def decode(data: bytes) -> str:
    """The text of a file: UTF-8 with or without byte order mark, else Latin-1 (which takes any byte).

    Lines may end as on any system: with LF, CR LF, LF CR, or CR alone.
    """
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("latin-1")
    for line_end in ("\r\n", "\n\r", "\r"):
        text = text.replace(line_end, "\n")
    return text


def is_utf8(data: bytes) -> bool:
    """Whether `decode` reads a file as UTF-8."""
    try:
        data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return False
    return True
