"""Reading the command line: POV-Ray's switches and INI statements, and long options, into one set of values.

::

    minipov scene.pov +W640 +H480 +A0.3 -o out.png
    minipov scene.ini[Low] Antialias=on Declare=Count=5
    minipov --width 640 --threads=2 scene.pov

Switches begin with + or - (which turns flags off) and their case does not matter. A value stands right behind its
switch; where it is missing, the next argument is taken.
"""

from __future__ import annotations

import difflib
import re
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from minipov.include_path import standard_folders
from minipov.ini import read_ini, split_section, split_statement, unquoted
from minipov.option_table import BY_KEY, BY_LONG_NAME, BY_SWITCH, OPTIONS, Option, Value

_TRUE = frozenset({"on", "true", "yes", "1", "y", "t"})
_LEADING_NUMBER = re.compile(r"\s*[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")
_LOOKS_LIKE_SWITCH = re.compile(r"[-+][A-Za-z]|--")
_FILE_TYPE = re.compile(r"([a-zA-Z])?(g)?(\d+)?", re.I)
_LONGEST_SWITCH = max(len(name) for name in BY_SWITCH)
_MAX_INI_DEPTH = 10


class UsageError(Exception):
    """The command line cannot be understood; exit status 2."""


@dataclass(slots=True)
class CommandLine:
    """The options in effect. ``given`` holds the keys that were set, ``warnings`` what to tell the user."""

    values: dict[str, Value] = field(default_factory=lambda: {option.key: option.default for option in OPTIONS})
    given: set[str] = field(default_factory=set)
    library_paths: list[Path] = field(default_factory=list)
    declares: dict[str, float | str] = field(default_factory=dict)
    warnings: list[str] = field(default_factory=list)

    def flag(self, key: str) -> bool:
        """Return a flag's value."""
        return bool(self.values[key])

    def integer(self, key: str) -> int:
        """Return a whole number's value."""
        return int(self.values[key])

    def number(self, key: str) -> float:
        """Return a number's value."""
        return float(self.values[key])

    def text(self, key: str) -> str:
        """Return a text's value."""
        return str(self.values[key])


def parse_command_line(arguments: Sequence[str], startup: Sequence[Path] = ()) -> CommandLine:
    """Read ``arguments`` after the INI files in ``startup``, which are read without remarks.

    Raises:
        UsageError: an unknown switch, a value that is none, a missing INI file.
    """
    reader = _Reader(CommandLine())
    for file in startup:
        reader.ini_file(file, "", quiet=True)
    reader.options.warnings.clear()
    reader.arguments(arguments)
    return reader.options


@dataclass(slots=True)
class _Reader:
    options: CommandLine
    quiet: bool = False
    depth: int = 0

    def arguments(self, words: Sequence[str]) -> None:
        waiting = deque(words)
        while waiting:
            self.argument(waiting.popleft(), waiting)

    def argument(self, word: str, following: deque[str]) -> None:
        if word in ("-help", "-version"):
            word = f"-{word}"
        if word.startswith("--"):
            self._long(word[2:], following)
        elif len(word) > 1 and word[0] in "+-":
            self._switch(word, following)
        elif (statement := split_statement(word)) is not None and not Path(word).is_file():
            self.statement(*statement)
        else:
            self._bare(word)

    def statement(self, key: str, value: str) -> None:
        option = BY_KEY.get(key.lower())
        if option is not None:
            self._set(option, value)
            return
        near = difflib.get_close_matches(key.lower(), BY_KEY, 1)
        meant = f"; did you mean {BY_KEY[near[0]].key}?" if near else ""
        self._warn(f"unknown option {key} is ignored{meant}")

    def ini_file(self, path: Path, section: str, *, quiet: bool = False) -> None:
        if self.depth >= _MAX_INI_DEPTH:
            raise UsageError(f"{path}: INI files include each other more than {_MAX_INI_DEPTH} deep")
        before = self.quiet
        self.quiet, self.depth = before or quiet, self.depth + 1
        try:
            for statement in read_ini(path, section):
                try:
                    if statement.key:
                        self.statement(statement.key, statement.value)
                    else:
                        self.argument(statement.value, deque())
                except UsageError as error:
                    raise UsageError(f"{path}:{statement.line}: {error}") from error
        except OSError as error:
            raise UsageError(f"cannot read {path}: {error.strerror}") from error
        finally:
            self.quiet, self.depth = before, self.depth - 1

    def _bare(self, word: str) -> None:
        """A word of its own: an INI file, or the scene."""
        name, section = split_section(word)
        path = Path(name)
        if path.suffix.lower() == ".ini" or section:
            self.ini_file(self._find_ini(name), section)
        elif path.is_dir():
            raise UsageError(f"{word} is a folder, not a scene")
        elif path.suffix or path.is_file() or path.with_name(path.name + ".pov").is_file() or name == "-":
            self._set(BY_KEY["input_file_name"], word)
        else:
            self.ini_file(self._find_ini(name + ".ini"), section)

    def _find_ini(self, name: str) -> Path:
        for folder in (Path(), *self.options.library_paths, *standard_folders()):
            if (folder / name).is_file():
                return folder / name
        raise UsageError(f"there is no INI file {name}" + (", nor a scene of that name" if "." in name else ""))

    def _long(self, text: str, following: deque[str]) -> None:
        name, equals, value = text.partition("=")
        name = name.lower().replace("_", "-")
        negated = name.startswith("no-") and name not in BY_LONG_NAME
        option = BY_LONG_NAME.get(name.removeprefix("no-") if negated else name)
        if option is None:
            near = difflib.get_close_matches(name, BY_LONG_NAME, 1)
            raise UsageError(f"unknown option --{name}" + (f"; did you mean --{near[0]}?" if near else ""))
        if option.kind == "flag":
            self._set(option, "off" if negated else value or "on")
        else:
            self._set(option, value if equals else self._next(f"--{name}", following))

    def _switch(self, word: str, following: deque[str]) -> None:
        sign, body = word[0], word[1:]
        for length in range(min(len(body), _LONGEST_SWITCH), 0, -1):
            option = BY_SWITCH.get(body[:length].lower())
            if option is not None:
                break
        else:
            raise UsageError(f"unknown switch {word}; minipov --help lists them")
        value = unquoted(body[length:])
        if body.lower() == "h" and not (following and following[0][:1].isdigit()):
            self._set(BY_KEY["help"], "on")
            return
        if option.kind != "flag":
            self._set(option, value or self._next(word, following))
            return
        self._set(option, "on" if sign == "+" or option.key == "Help" else "off")
        if value and option.carries:
            self._set(BY_KEY[option.carries.lower()], value)
        elif value and option.support == "honoured":
            raise UsageError(f"{word}: the switch {sign}{body[:length]} takes no value")

    def _next(self, word: str, following: deque[str]) -> str:
        if not following or _LOOKS_LIKE_SWITCH.match(following[0]):
            raise UsageError(f"{word} needs a value")
        return following.popleft()

    def _set(self, option: Option, text: str) -> None:
        if option.support == "not yet" and text.lower() not in ("off", "no", "false", "0"):
            self._warn(f"{option.key} is not supported and is ignored")
        if option.key == "Library_Path":
            self.options.library_paths.append(Path(text))
        elif option.key == "Declare":
            self._declare(text)
        elif option.key == "Include_Ini":
            name, section = split_section(text)
            self.ini_file(self._find_ini(name), section)
        elif option.kind == "file type":
            self._file_type(text)
        else:
            self.options.values[option.key] = _value(option, text)
        self.options.given.add(option.key)

    def _declare(self, text: str) -> None:
        """``Name=1.5``: POV-Ray reads as much of the value as is a number; a quoted value is a string, as in 3.8."""
        name, equals, value = (part.strip() for part in text.partition("="))
        if not equals or not name.isidentifier():
            raise UsageError(f"Declare={text}: expected Declare=Name=value")
        number = _LEADING_NUMBER.match(value)
        if value[:1] in ("'", '"'):
            self.options.declares[name] = unquoted(value)
        elif number is not None:
            self.options.declares[name] = float(number.group(0))
        else:
            raise UsageError(f"Declare={text}: {value or 'nothing'} is not a number")

    def _file_type(self, text: str) -> None:
        """``N16``, ``Pg``: a letter, g for grey, and bits per colour."""
        match = _FILE_TYPE.fullmatch(text)
        letter = (match.group(1) or "").upper() if match else ""
        if match is None or (letter and letter not in "NTCPBJEHS"):
            raise UsageError(f"unknown type of output file: {text}")
        found: dict[str, Value] = {"Output_File_Type": letter}
        if match.group(2):
            found["Grayscale_Output"] = True
        if match.group(3):
            found["Compression" if letter == "J" else "Bits_Per_Color"] = int(match.group(3))
        self.options.values |= found
        self.options.given |= found.keys()

    def _warn(self, text: str) -> None:
        if not self.quiet and text not in self.options.warnings:
            self.options.warnings.append(text)


def _value(option: Option, text: str) -> Value:
    """Turn text into the option's kind of value; whole numbers may be written as floats."""
    if option.kind == "flag":
        return text.strip().lower() in _TRUE
    if option.kind in ("text", "repeated") or option.support == "accepted":
        return text
    try:
        number = float(text)
    except ValueError:
        raise UsageError(f"{option.key}: {text!r} is not a number") from None
    if option.kind == "integer":
        return int(number)
    return int(number) if option.kind == "place" and number == int(number) and "." not in text else number
