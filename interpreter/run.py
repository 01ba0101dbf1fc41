"""Running a compiled scene, from its text to a `Scene`; Python's own exceptions become `SdlError`."""

from __future__ import annotations

import gc
import sys
import threading
from collections.abc import Callable
from contextvars import copy_context
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

from minipov.interpreter.cache import compile_text, compiled
from minipov.interpreter.compiler.program import Program
from minipov.interpreter.constructs.default import set_version
from minipov.interpreter.constructs.scene import finished
from minipov.interpreter.context import Context, Options, set_current_context
from minipov.interpreter.errors import NOWHERE, Messages, SdlError
from minipov.interpreter.runtime.faults import explained
from minipov.interpreter.runtime.library import library
from minipov.interpreter.runtime.program import Running
from minipov.interpreter.runtime.recovery import Recovery
from minipov.interpreter.runtime.search import FileSearch
from minipov.tracer.scene import Scene

T = TypeVar("T")

DEEPEST_RECURSION = 20_000
"""How many calls may be open in a running scene; beyond, a macro calls itself without end."""

_STACK_BYTES = 512 * 1024 * 1024


def load(path: str | Path, options: Options | None = None, messages: Messages | None = None) -> Scene:
    """The scene of a file.

    Raises:
        SdlError: the scene cannot be read; its place says where.
    """
    try:
        content = Path(path).read_bytes()
    except OSError as error:
        raise SdlError(f"cannot read '{path}': {error.strerror or error}") from None
    return _run(str(path), content, options or Options(), messages or Messages(), Path(path).parent)


def load_text(
    text: str, name: str = "scene.pov", options: Options | None = None, messages: Messages | None = None
) -> Scene:
    """The scene of a text; ``name`` stands in messages, and includes are searched beside it.

    Raises:
        SdlError: the scene cannot be read; its place says where.
    """
    return _run(name, text.encode(), options or Options(), messages or Messages(), Path(name).parent)


def mistakes(path: str | Path, options: Options | None = None, messages: Messages | None = None) -> list[SdlError]:
    """What stops a scene: after a mistake this goes on with the next statement of the scene's own file, where it can.

    The last of several may have ended the run.
    """
    found: list[SdlError] = []
    try:
        content = Path(path).read_bytes()
        _run(str(path), content, options or Options(), messages or Messages(), Path(path).parent, found)
    except OSError as error:
        return [SdlError(f"cannot read '{path}': {error.strerror or error}")]
    except SdlError as error:
        found.append(error)
    return found


def _run(
    name: str,
    content: bytes,
    options: Options,
    messages: Messages,
    folder: Path,
    problems: list[SdlError] | None = None,
) -> Scene:
    search = FileSearch(options.library_paths, options.files, [folder])
    context = Context(options, messages, search.find)
    if options.version is not None:
        set_version(context, options.version)
    return _with_deep_stack(lambda: _read(name, content, context, search, problems))


def _read(name: str, content: bytes, context: Context, search: FileSearch, problems: list[SdlError] | None) -> Scene:
    """The scene; with a list for ``problems``, mistakes are put there where the run can go on."""
    set_current_context(context)
    running = Running(context, search, compiled)
    running.input_file_name = name
    running.library = library(running)
    if problems is not None:
        running.load = partial(_compiled_recovering, name)
        running.library["recovered"] = Recovery(running, name, problems).recovered
    try:
        running.run(name, content)
        running.blocks.finish(NOWHERE)
    except Exception as error:
        raise explained(error, running.sources) from None
    finally:
        running.files.close_all()
    if problems:
        raise problems.pop()
    if not context.version_was_set:
        context.messages.warn("there is no #version directive: an old version is assumed", (name, 1, 1))
    return finished(context)


def _compiled_recovering(main: str, path: str, content: bytes) -> Program:
    """Only the scene's own file goes on after a mistake."""
    return compile_text(path, content, recovering=True) if path == main else compiled(path, content)


def _with_deep_stack(work: Callable[[], T]) -> T:
    """Run in a thread whose stack holds deep recursion."""
    outcome: list[Any] = []

    def run() -> None:
        limit, collects = sys.getrecursionlimit(), gc.isenabled()
        sys.setrecursionlimit(max(limit, DEEPEST_RECURSION))
        gc.disable()  # a scene is one large tree without cycles, and looking for them takes long
        try:
            outcome.extend((True, work()))
        except BaseException as error:
            outcome.extend((False, error))
        finally:
            sys.setrecursionlimit(limit)
            if collects:
                gc.enable()

    size = threading.stack_size(_STACK_BYTES)
    try:
        thread = threading.Thread(target=copy_context().run, args=(run,), name="minipov scene", daemon=True)
        thread.start()
    finally:
        threading.stack_size(size)
    while thread.is_alive():
        thread.join(0.2)
    succeeded, result = outcome
    if not succeeded:
        raise result
    return result  # type: ignore[no-any-return]  # what work gave
