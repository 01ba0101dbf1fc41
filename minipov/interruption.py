"""Ctrl-C: the first one interrupts, further ones do not disturb what is saved then."""

from __future__ import annotations

import signal
from types import FrameType


def interrupt_once() -> None:
    """From now on, Ctrl-C raises KeyboardInterrupt once and then no more. To be called in the main thread.

    Later ones meet a handler that does nothing, not one that ignores them: programs that are started meanwhile can
    still be interrupted.
    """
    signal.signal(signal.SIGINT, _first)


def _first(number: int, frame: FrameType | None) -> None:
    signal.signal(signal.SIGINT, _further)
    raise KeyboardInterrupt


def _further(number: int, frame: FrameType | None) -> None:
    pass
