"""SDL: the functions of strings: ``str``, ``vstr``, ``concat``, ``substr``, ``val``, ``datetime`` ..."""

from __future__ import annotations

import math
import re
import time
from datetime import UTC, datetime
from typing import Any

from minipov.interpreter.errors import SdlError
from minipov.interpreter.runtime.signature import builtin
from minipov.interpreter.values import Vector, kind_of, terms

_EPOCH = datetime(2000, 1, 1, tzinfo=UTC)
_NUMBER = re.compile(
    r"\s*([+-]?(?:0[xX][0-9a-fA-F]+|inf(?:inity)?|nan|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?))", re.IGNORECASE
)
_LONGEST = 250


def text(value: Any) -> str:
    """A string argument."""
    if isinstance(value, str):
        return value
    raise SdlError(f"expected a string, found {kind_of(value)}", hint="str() and vstr() make strings of numbers")


def formatted(value: float, width: float, precision: float) -> str:
    """A float as C's printf writes it: at least ``abs(width)`` characters, zeros in front if ``width`` is negative."""
    places = int(precision) if precision >= 0 else 6
    size = min(abs(int(width)), _LONGEST)
    if not math.isfinite(value):
        word = "inf" if math.isinf(value) else "nan"
        return f"{'-' if math.copysign(1, value) < 0 else ''}{word}".rjust(size)
    return f"{value:{'0' if width < 0 else ''}{size or ''}.{min(places, _LONGEST)}f}"


@builtin("str", 3)
def str_(value: float, width: float, precision: float) -> str:
    """A float as text."""
    if value.__class__ is not float:
        (value,) = terms(value) if not isinstance(value, Vector) else (_refuse_vector(value),)
    return formatted(value, width, precision)


def _refuse_vector(value: Vector) -> float:
    raise SdlError(f"expected a number, found {kind_of(value)}", hint="vstr() makes a string of a vector")


@builtin("vstr", 5)
def vstr(count: float, vector: Any, separator: str, width: float, precision: float) -> str:
    """Two to five terms as text."""
    values = (*terms(vector), 0.0, 0.0, 0.0, 0.0)[: max(2, min(5, int(count)))]
    return text(separator).join(formatted(value, width, precision) for value in values)


@builtin("concat", 1, 10**6)
def concat(*parts: str) -> str:
    """Strings joined."""
    try:
        return "".join(parts)
    except TypeError:
        return "".join(map(text, parts))


@builtin("substr", 3)
def substr(whole: str, start: float, length: float) -> str:
    """``length`` characters from ``start``, counted from 1."""
    first, count = int(start) - 1, int(length)
    if first < 0 or count < 0 or first + count > len(text(whole)):
        raise SdlError(f"substr({start:g}, {length:g}) reaches outside a string of {len(whole)} characters")
    return whole[first : first + count]


@builtin("strupr", 1)
def strupr(whole: str) -> str:
    """In capitals."""
    return text(whole).upper()


@builtin("strlwr", 1)
def strlwr(whole: str) -> str:
    """In small letters."""
    return text(whole).lower()


@builtin("strlen", 1)
def strlen(whole: str) -> float:
    """How many characters."""
    return float(len(text(whole)))


@builtin("strcmp", 2)
def strcmp(a: str, b: str) -> float:
    """0 for equal strings, else the distance of the first two codes that differ (0 behind the end)."""
    return next((float(ord(p) - ord(q)) for p, q in zip(text(a) + "\0", text(b) + "\0", strict=False) if p != q), 0.0)


@builtin("asc", 1)
def asc(whole: str) -> float:
    """The code of the first character; 0 for an empty string."""
    return float(ord(text(whole)[0])) if whole else 0.0


@builtin("chr", 1)
def chr_(code: float) -> str:
    """The character of a code."""
    if not 0 <= int(code) <= 0x10FFFF:
        raise SdlError(f"there is no character {code:g}")
    return chr(int(code)) if int(code) else ""  # a zero ends a string


@builtin("val", 1)
def val(whole: str) -> float:
    """The number at the start of a string; 0 if there is none."""
    match = _NUMBER.match(text(whole))
    if match is None:
        return 0.0
    number = match.group(1)
    return float(int(number, 16)) if "x" in number.lower() else float(number)


@builtin("datetime", 1, 2)
def datetime_(days: float, pattern: str = "%Y-%m-%d %H:%M:%SZ") -> str:
    """A day count since 2000-01-01 UTC as text, in strftime's format."""
    if not pattern:
        raise SdlError("datetime needs a format that is not empty")
    try:
        moment = time.gmtime(_EPOCH.timestamp() + math.floor(days * 86400 + 0.5))
        return time.strftime(pattern, moment)
    except (OverflowError, ValueError, OSError) as error:
        raise SdlError(f"datetime cannot write day {days:g}: {error}") from None


def now() -> float:
    """The variable ``now``: days since 2000-01-01 00:00 UTC."""
    return (datetime.now(UTC) - _EPOCH).total_seconds() / 86400


@builtin("file_exists", 1, runtime=True)
def file_exists(runtime: Any, name: str) -> float:
    """Whether a file is found where includes are searched."""
    return float(runtime.find_file(text(name), ()) is not None)
