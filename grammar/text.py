"""The text of an SDL file: its bytes as characters."""

from __future__ import annotations


def decode(data: bytes) -> str:
    """The text of a file: UTF-8 with or without byte order mark, else Latin-1 (which takes any byte)."""
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("latin-1")
