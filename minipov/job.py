"""One run of the program: every frame of a scene is loaded, rendered and written."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path

from minipov.console import Console
from minipov.exit_status import INTERRUPTED, OK, SCENE_ERROR
from minipov.frames import Frame, frames
from minipov.image_format import FileFormat
from minipov.interpreter import Messages, SdlError, load, load_text
from minipov.option_writer import write_ini
from minipov.options import CommandLine, UsageError
from minipov.output_name import file_format, output_path
from minipov.pipeline import load_options, render_settings, start, trace
from minipov.statistics_table import statistics_table
from minipov.tracer.render import RenderJob
from minipov.tracer.settings import RenderSettings
from minipov.unfinished import Unfinished

_ENTRY = "command line"


def run(command: CommandLine) -> int:
    """Render what ``command`` asks for and return the exit status.

    Raises:
        UsageError: options that contradict each other.
    """
    console = Console(command)
    for warning in command.warnings:
        console.warn(warning)
    if not command.text("Input_File_Name"):
        raise UsageError("no scene is given")
    settings, file = render_settings(command), file_format(command)
    wanted = frames(command)
    if not wanted:
        raise UsageError("no frame is left to render")
    if command.text("Create_Ini"):
        write_ini(command, Path(command.text("Create_Ini")))
    scene, sources = _scene_source(command)
    try:
        for frame in wanted:
            _render_frame(command, console, scene, sources, frame, settings, file)
    except SdlError as error:
        console.scene_error(error, sources)
        return SCENE_ERROR
    except OSError as error:
        console.error(f"{error.filename}: {error.strerror}" if error.filename else str(error))
        return SCENE_ERROR
    except (RuntimeError, MemoryError, RecursionError) as error:
        console.error(str(error) or type(error).__name__)
        return SCENE_ERROR
    except KeyboardInterrupt:
        console.error("interrupted")
        return INTERRUPTED
    return OK


def _scene_source(command: CommandLine) -> tuple[Path, dict[str, bytes]]:
    """Return the scene's path and the texts that are not files.

    Standard input is one; another, under the name `_ENTRY`, stands before the scene to read the header of ``+HI``.
    """
    name = command.text("Input_File_Name")
    sources: dict[str, bytes] = {}
    if name == "-":
        scene = Path("stdin")
        sources["stdin"] = sys.stdin.buffer.read()
    else:
        scene = _with_extension(Path(name), command.library_paths)
    header = command.text("Include_Header")
    before = f'#include "{header}"\n' if header else ""
    if sources or header:
        sources[_ENTRY] = f'{before}#include "{scene}"\n'.encode()
    return scene, sources


def _with_extension(name: Path, library_paths: list[Path]) -> Path:
    """Find the scene, adding .pov, here and in the library paths; the name as it is where it is nowhere."""
    for folder in (Path(), *library_paths):
        for candidate in (folder / name, folder / (str(name) + ".pov"), folder / (str(name) + ".POV")):
            if candidate.is_file():
                return candidate
    return name


def _render_frame(
    command: CommandLine,
    console: Console,
    scene: Path,
    sources: dict[str, bytes],
    frame: Frame,
    settings: RenderSettings,
    file: FileFormat,
) -> None:
    target = output_path(command, scene, frame, file.kind) if command.flag("Output_to_File") else None
    if target is not None and target != "-":
        _check_writable(target)
    console.heading("Parsing...")
    started = time.perf_counter()
    options, messages = load_options(command, frame, sources), Messages(sink=console.message)
    text = sources.get(_ENTRY)
    loaded = load(scene, options, messages) if text is None else load_text(text.decode(), _ENTRY, options, messages)
    load_seconds = time.perf_counter() - started
    console.heading("Rendering...")
    state = None
    if isinstance(target, Path):
        content = sources.get(str(scene)) or scene.read_bytes()
        state = Unfinished(target, content, frame, settings)
    earlier = state.read() if state is not None and command.flag("Continue_Trace") else None
    job = start(loaded, settings, earlier)
    # Loaded while the render goes on.
    from minipov.image_output import write_image

    for feature, place in job.unsupported:
        console.warn(f"{feature} is not rendered yet" + (f" ({place})" if place else ""))
    working = loaded.settings.assumed_gamma
    try:
        with console.progress(settings.width * settings.height) as progress:
            result = trace(job, _saving(job, state, progress))
    except KeyboardInterrupt:
        if target is not None:
            write_image(target, job.snapshot(), working, file)
        if state is not None:
            state.save(job.unfinished())
        raise
    if target is not None:
        write_image(target, result.pixels, working, file)
    if state is not None:
        state.remove()
    if console.verbose or command.flag("Statistics"):
        console.say("Statistic", statistics_table(result.statistics, load_seconds))


def _saving(job: RenderJob, state: Unfinished | None, progress: Callable[[float], None]) -> Callable[[float], None]:
    """Call ``progress``, and save the state of a long render now and then."""

    def report(share: float) -> None:
        progress(share)
        if state is not None and state.is_due:
            state.save(job.unfinished())

    return report


def _check_writable(target: Path) -> None:
    """Find out before all the work whether the picture can be written; raises OSError."""
    if target.is_dir():
        raise IsADirectoryError(21, "is a folder", str(target))
    probe = target.with_name(f".{target.name}.part")
    try:
        probe.touch()
        probe.unlink()
    except OSError as error:
        raise OSError(error.errno, f"cannot be written: {error.strerror}", str(target)) from None
