"""INI: ``Post_Frame_Command="convert %o %s.gif"  Post_Frame_Return=F``: programs that run before and after frames.

A command is given to the shell, with ``%o`` the picture's file, ``%s`` the scene's name, ``%n`` the frame, ``%k`` the
clock, ``%w`` and ``%h`` the size, ``%%`` a percent sign. What follows when it fails is said by the letter of
``…_Return``; a ``-`` or ``!`` before the letter means: when it succeeds. I ignores, S skips the frame, A skips all
further frames, Q ends the run, U ends it as Ctrl-C would, F as an error.
"""

from __future__ import annotations

import re
import subprocess
from pathlib import Path
from typing import Literal, TypeAlias, cast

from minipov.frames import Frame
from minipov.options import CommandLine, UsageError

Moment: TypeAlias = Literal["Pre_Scene", "Pre_Frame", "Post_Frame", "Post_Scene", "User_Abort", "Fatal_Error"]
Action: TypeAlias = Literal["I", "S", "A", "Q", "U", "F"]

_RETURN = re.compile(r"([-!]?)([ISAQUF])\w*", re.I)


def shell_out(command: CommandLine, moment: Moment, scene: Path, frame: Frame, picture: Path | str) -> Action:
    """Run the command of a moment, if there is one, and return what is to be done.

    Raises:
        UsageError: the ``…_Return`` is none.
    """
    text = command.text(f"{moment}_Command")
    if not text:
        return "I"
    wanted = _RETURN.fullmatch(command.text(f"{moment}_Return") or "I")
    if wanted is None:
        raise UsageError(f"{moment}_Return={command.text(f'{moment}_Return')}: I, S, A, Q, U and F are possible")
    values = {
        "o": str(picture),
        "s": scene.stem,
        "n": str(frame.frame_number),
        "k": f"{frame.clock:g}",
        "w": str(command.integer("Width")),
        "h": str(command.integer("Height")),
        "%": "%",
    }
    line = re.sub("%([osnkwh%])", lambda match: values[match.group(1)], text)
    failed = subprocess.run(line, shell=True, check=False).returncode != 0
    inverted = wanted.group(1) != ""
    return cast(Action, wanted.group(2).upper()) if failed != inverted else "I"
