"""One run of the program: every frame of a scene is loaded, rendered and written."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

from minipov.console import Console
from minipov.exit_status import INTERRUPTED, OK, SCENE_ERROR
from minipov.frame_render import ENTRY, FrameRender
from minipov.frames import Frame, frames
from minipov.interpreter import SdlError
from minipov.option_writer import write_ini
from minipov.options import CommandLine, UsageError
from minipov.output_name import file_format, output_path
from minipov.pipeline import render_settings
from minipov.shellout import Action, Moment, shell_out


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
    render = FrameRender(command, console, scene, sources, settings, file)
    at = wanted[0]

    def shell(moment: Moment) -> Action:
        action = shell_out(command, moment, scene, at, output_path(command, scene, at, file.kind))
        if action == "U":
            raise KeyboardInterrupt
        if action == "F":
            raise RuntimeError(f"{moment}_Command failed")
        return action

    try:
        action = shell("Pre_Scene")
        for at in wanted if action == "I" else ():
            action = _render_frame(render, at, shell)
            if action in ("A", "Q"):
                break
        if action != "Q":
            shell("Post_Scene")
    except KeyboardInterrupt:
        console.error("interrupted")
        shell_out(command, "User_Abort", scene, at, output_path(command, scene, at, file.kind))
        return INTERRUPTED
    except SdlError as error:
        console.scene_error(error, sources)
    except OSError as error:
        console.error(f"{error.filename}: {error.strerror}" if error.filename else str(error))
    except (RuntimeError, MemoryError, RecursionError) as error:
        console.error(str(error) or type(error).__name__)
    else:
        return OK
    shell_out(command, "Fatal_Error", scene, at, output_path(command, scene, at, file.kind))
    return SCENE_ERROR


def _render_frame(render: FrameRender, frame: Frame, shell: Callable[[Moment], Action]) -> Action:
    """Render a frame between its commands, and return what the last of them wants."""
    action = shell("Pre_Frame")
    if action != "I":
        return action
    render(frame)
    return shell("Post_Frame")


def _scene_source(command: CommandLine) -> tuple[Path, dict[str, bytes]]:
    """Return the scene's path and the texts that are not files.

    Standard input is one; another, under the name `ENTRY`, stands before the scene to read the header of ``+HI``.
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
        sources[ENTRY] = f'{before}#include "{scene}"\n'.encode()
    return scene, sources


def _with_extension(name: Path, library_paths: list[Path]) -> Path:
    """Find the scene, adding .pov, here and in the library paths; the name as it is where it is nowhere."""
    for folder in (Path(), *library_paths):
        for candidate in (folder / name, folder / (str(name) + ".pov"), folder / (str(name) + ".POV")):
            if candidate.is_file():
                return candidate
    return name
