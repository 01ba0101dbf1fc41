"""Where in the scene a running program is: the positions that compiled code carries, read from Python's own frames."""

from __future__ import annotations

import sys
from itertools import pairwise
from types import CodeType, FrameType, TracebackType
from typing import Final
from weakref import WeakKeyDictionary

from minipov.interpreter.errors import NOWHERE, Place

MARK: Final = "__sdl__"
"""A global of every compiled file, by which its frames are known; holds the file's name."""

SHAPE_PREFIX: Final = "shape_"
"""The start of the Python name of the function of statements alike."""

MACRO_PREFIX: Final = "macro_"
"""The start of the Python name of a macro's function; the file's own code is named differently."""


_positions: WeakKeyDictionary[CodeType, list[tuple[int, int]]] = WeakKeyDictionary()


def position(code: CodeType, instruction: int, file: str) -> Place:
    """The place of the instruction at byte ``instruction``."""
    positions = _positions.get(code)
    if positions is None:
        positions = _positions[code] = [(line or 0, (column or 0) + 1) for line, _, column, _ in code.co_positions()]
    line, column = positions[instruction // 2] if instruction >= 0 else (0, 1)
    return (file, line, column)


def is_scene(frame: FrameType) -> bool:
    """Whether a frame runs compiled SDL."""
    return MARK in frame.f_globals


def _place(frame: FrameType, instruction: int) -> Place:
    return position(frame.f_code, instruction, frame.f_globals[MARK])


def current_place() -> Place:
    """The place of the innermost compiled code that runs now."""
    frame: FrameType | None = sys._getframe(1)
    while frame is not None and not is_scene(frame):
        frame = frame.f_back
    return NOWHERE if frame is None else _place(frame, frame.f_lasti)


def trace(traceback: TracebackType | None) -> list[tuple[str, Place]]:
    """The compiled frames of an exception, innermost first: the macro's name ("" for a file's own code) and place.

    Statements alike, called by their file's code, do not count as another frame.
    """
    frames: list[tuple[str, Place]] = []
    while traceback is not None:
        if is_scene(traceback.tb_frame):
            name = traceback.tb_frame.f_code.co_name
            macro = name.removeprefix(MACRO_PREFIX) if name.startswith(MACRO_PREFIX) else ""
            if name.startswith(SHAPE_PREFIX) and frames:
                frames.pop()
            frames.append((macro, _place(traceback.tb_frame, traceback.tb_lasti)))
        traceback = traceback.tb_next
    frames.reverse()
    return frames


def call_stack(frames: list[tuple[str, Place]]) -> tuple[tuple[str, Place], ...]:
    """The calls and includes that led to the innermost of ``frames``, as `SdlError.stack` has them."""
    stack = []
    for (name, (file, _, _)), (_, caller) in pairwise(frames):
        stack.append((f"in macro {name}" if name else f"in {file}", caller))
    return tuple(stack)
