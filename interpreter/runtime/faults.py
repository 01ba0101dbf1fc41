"""Exceptions of a running scene, whatever their kind, as errors that name a place in the scene."""

from __future__ import annotations

import dis
import re
from collections.abc import Mapping

from minipov.interpreter.errors import NOWHERE, SdlError
from minipov.interpreter.runtime.places import call_stack, is_scene, trace
from minipov.interpreter.values import COMPONENTS

_STACK_SHOWN = 12


def explained(error: Exception, sources: Mapping[str, str]) -> SdlError:
    """The error that a user sees, with the place where it arose and the calls that led there.

    Raises:
        Exception: ``error`` itself, where no scene code was running: that is a defect of this program.
    """
    frames = trace(error.__traceback__)
    if not isinstance(error, SdlError):
        if not frames:
            raise error
        message, hint = _in_words(error)
        if isinstance(error, IndexError):
            message = f"the vector is too short for its component '{_attribute_at(error)}'"
        error = SdlError(message, hint=hint)
    if frames and error.place == NOWHERE:
        error.place = frames[0][1]
    stack = call_stack(frames)
    error.stack = stack if len(stack) <= _STACK_SHOWN else (*stack[:_STACK_SHOWN], ("...", NOWHERE))
    return error


def _attribute_at(error: Exception) -> str:
    """The attribute that was being read in the innermost scene code."""
    traceback, name = error.__traceback__, ""
    while traceback is not None:
        if is_scene(traceback.tb_frame):
            instructions = dis.get_instructions(traceback.tb_frame.f_code)
            at = traceback.tb_lasti
            name = next((str(step.argval) for step in instructions if step.offset == at), "")
        traceback = traceback.tb_next
    return name


_ATTRIBUTE = re.compile(r"'(\w+)' object has no attribute '(\w+)'")
_OPERANDS = re.compile(r"unsupported operand type\(s\) for (.+): '(\w+)' and '(\w+)'")
_UNARY = re.compile(r"bad operand type for (.+): '(\w+)'")
_COMPARED = re.compile(r"'(.+)' not supported between instances of '(\w+)' and '(\w+)'")
_REAL = re.compile(r"must be real number, not (\w+)")

_KINDS = {"float": "a number", "int": "a number", "bool": "a number", "str": "a string", "Vector": "a vector"}


def _kind(python: str) -> str:
    known = _KINDS.get(python)
    if known is not None:
        return known
    name = python.lower()
    return f"an {name}" if name[0] in "aeiou" else f"a {name}"


def _in_words(error: Exception) -> tuple[str, str | None]:
    """What went wrong, in SDL's terms."""
    text = str(error)
    if isinstance(error, RecursionError):
        return "endless recursion: calls are nested too deeply", "a macro that calls itself must stop at some point"
    if isinstance(error, MemoryError):
        return "the scene needs more memory than there is", None
    if isinstance(error, OverflowError):
        return "a number is too large", None
    if match := _ATTRIBUTE.search(text):
        return _no_attribute(match[1], match[2])
    if match := _OPERANDS.search(text):
        return f"{_kind(match[2])} and {_kind(match[3])} cannot be joined by '{match[1]}'", _hint_for(
            match[2], match[3]
        )
    if match := _UNARY.search(text):
        return f"'{match[1].removeprefix('unary ')}' does not go with {_kind(match[2])}", None
    if match := _COMPARED.search(text):
        return f"{_kind(match[2])} and {_kind(match[3])} cannot be compared", None
    if match := _REAL.search(text):
        return f"expected a number, found {_kind(match[1])}", None
    return text[:1].lower() + text[1:] if text else type(error).__name__, None


def _no_attribute(python: str, attribute: str) -> tuple[str, str | None]:
    if attribute in ("fetch", "assign", "erase"):
        return f"{_kind(python)} has no elements", "subscripts need an array"
    if attribute in COMPONENTS or attribute == "gray":
        return f"{_kind(python)} has no component '{attribute}'", None
    return f"{_kind(python)} cannot be used here", None


def _hint_for(left: str, right: str) -> str | None:
    return "concat() joins strings, str() makes one of a number" if "str" in (left, right) else None
