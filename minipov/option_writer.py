"""``Create_Ini=file``, ``+GIfile``: the options that were set, as an INI file that can be read again."""

from __future__ import annotations

from pathlib import Path

from minipov.option_table import OPTIONS, Value
from minipov.options import CommandLine, UsageError

_LISTED = frozenset({"Library_Path", "Declare"})


def write_ini(command: CommandLine, path: Path) -> None:
    """Write the options of ``command``.

    Raises:
        UsageError: the file cannot be written.
    """
    options = [option for option in OPTIONS if option.key in command.given - _LISTED - {"Create_Ini", "Include_Ini"}]
    lines = [f"{option.key}={_text(command.values[option.key])}" for option in options]
    lines += [f'Library_Path="{folder}"' for folder in command.library_paths]
    lines += [f"Declare={name}={_quoted(value)}" for name, value in command.declares.items()]
    try:
        path.write_text("\n".join(lines) + "\n")
    except OSError as error:
        raise UsageError(f"cannot write {path}: {error.strerror}") from error


def _text(value: Value) -> str:
    """A value as INI files have it."""
    if isinstance(value, bool):
        return "on" if value else "off"
    return f'"{value}"' if isinstance(value, str) and not value.replace(".", "").isalnum() else str(value)


def _quoted(value: float | str) -> str:
    return f'"{value}"' if isinstance(value, str) else repr(value)
