"""One run of the program: every frame of a scene is loaded, rendered and written."""

from __future__ import annotations

import sys
import time
from pathlib import Path

from minipov.console import Console
from minipov.frames import Frame, frames
from minipov.image_output import FileFormat, write_image
from minipov.interpreter import Messages, SdlError, load, load_text
from minipov.options import CommandLine, UsageError
from minipov.output_name import file_format, output_path
from minipov.pipeline import load_options, render_settings, trace
from minipov.statistics_table import statistics_table
from minipov.tracer.render import RenderJob
from minipov.tracer.settings import RenderSettings

OK, SCENE_ERROR, USAGE_ERROR, INTERRUPTED = 0, 1, 2, 130
_ENTRY = "command line"


def run(command: CommandLine, console: Console) -> int:
    """Render what ``command`` asks for and return the exit status.

    Raises:
        UsageError: options that contradict each other.
    """
    if not command.text("Input_File_Name"):
        raise UsageError("no scene is given")
    settings, file = render_settings(command), file_format(command)
    wanted = frames(command)
    if not wanted:
        raise UsageError("no frame is left to render")
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
    target = output_path(command, scene, frame, file.kind)
    if target != "-" and not target.parent.is_dir():
        raise FileNotFoundError(2, "no such folder", str(target.parent))
    console.heading("Parsing...")
    started = time.perf_counter()
    options, messages = load_options(command, frame, sources), Messages(sink=console.message)
    text = sources.get(_ENTRY)
    loaded = load(scene, options, messages) if text is None else load_text(text.decode(), _ENTRY, options, messages)
    load_seconds = time.perf_counter() - started
    console.heading("Rendering...")
    job = RenderJob(loaded, settings)
    for feature, place in job.unsupported:
        console.warn(f"{feature} is not rendered yet" + (f" ({place})" if place else ""))
    working = loaded.settings.assumed_gamma
    pixels = settings.width * settings.height
    try:
        with console.progress(pixels) as progress:
            result = trace(job, progress)
    except KeyboardInterrupt:
        if command.flag("Output_to_File"):
            write_image(target, job.snapshot(), working, file)
        raise
    if command.flag("Output_to_File"):
        write_image(target, result.pixels, working, file)
    if console.verbose or command.flag("Statistics"):
        console.say("Statistic", statistics_table(result.statistics, load_seconds))
