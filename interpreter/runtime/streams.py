"""SDL: ``#debug "text\\n"``, ``#warning "..."``, ``#error "..."``: what a scene tells its user."""

from __future__ import annotations

from minipov.interpreter.errors import HaltedError, Message, Messages, Place
from minipov.interpreter.runtime.strings import text

_DEBUG_LIMIT, _DEBUG_CUT = 200, 159
_LIMIT, _CUT = 160, 127


class DebugStream:
    """Text of ``#debug``, passed on line by line; what follows the last line end is lost, as POV-Ray loses it."""

    def __init__(self, messages: Messages) -> None:
        self._messages = messages
        self._line = ""

    def write(self, message: str, place: Place) -> None:
        """Add text; complete lines go out."""
        *lines, self._line = (self._line + shortened(text(message), _DEBUG_LIMIT, _DEBUG_CUT)).split("\n")
        for line in lines:
            self._messages.say(Message("debug", line, place))


def shortened(message: str, limit: int, cut: int) -> str:
    """Text longer than ``limit``, cut to ``cut`` characters, the last three of which are dots."""
    return message if len(message) <= limit else message[: cut - 3] + "..."


def warning(message: str) -> str:
    """The text of ``#warning``."""
    return shortened(text(message), _LIMIT, _CUT).removesuffix("\n")


def halted(message: str) -> HaltedError:
    """What ``#error`` raises."""
    return HaltedError(f"halted by #error: {shortened(text(message), _LIMIT, _CUT).strip()}")
