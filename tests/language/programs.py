"""The language programs: small scenes that print, with what they print as comments.

    // what the program is about
    // switches: +K0.75          switches it is run with, if any
    // only: minipov             for what POV-Ray 3.7 does not have
    #debug concat(str(1 + 2, 0, 0), "\\n") // expect: 3

The expected lines stand beside the ``#debug`` that prints them, or together at the end where loops and macros print.
They were taken from POV-Ray.
"""

import re
from dataclasses import dataclass
from pathlib import Path

FOLDER = Path(__file__).parent


@dataclass(frozen=True, slots=True)
class Program:
    """One program and its expectations."""

    path: Path
    expected: tuple[str, ...]
    switches: tuple[str, ...]
    minipov_only: bool

    @property
    def name(self) -> str:
        """Folder and name, as in ``macros/by_reference``."""
        return self.path.relative_to(FOLDER).with_suffix("").as_posix()


def read_program(path: Path) -> Program:
    """Read one file."""
    text = path.read_text(encoding="utf-8")
    expected = tuple(line.rstrip() for line in re.findall(r"// expect: ?(.*)$", text, re.MULTILINE))
    switches = re.search(r"^// switches: (.*)$", text, re.MULTILINE)
    return Program(path, expected, tuple(switches[1].split()) if switches else (), "\n// only: minipov\n" in text)


PROGRAMS = tuple(read_program(path) for path in sorted(FOLDER.glob("*/*.pov")))
