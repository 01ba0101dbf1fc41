"""Every program prints the same on minipov and on POV-Ray."""

import itertools
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import minipov_text
import povray_text
import pytest
from programs import PROGRAMS, Program

BY_FOLDER = {
    folder: tuple(program for program in programs if not program.minipov_only)
    for folder, programs in itertools.groupby(PROGRAMS, key=lambda program: program.path.parent.name)
}


def test_every_program_expects_something() -> None:
    assert [program.name for program in PROGRAMS if not program.expected] == []


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.name)
def test_minipov(program: Program, tmp_path: Path) -> None:
    said = minipov_text.run_minipov(program.path, tmp_path, program.switches)
    assert said.error is None, str(said.error)
    assert said.debug == program.expected


@pytest.mark.skipif(povray_text.PROGRAM is None, reason="POV-Ray is not installed")
@pytest.mark.parametrize("folder", sorted(folder for folder, programs in BY_FOLDER.items() if programs))
def test_povray(folder: str, tmp_path: Path) -> None:
    """POV-Ray waits more than it works, so a folder of programs is run at once."""

    def run(program: Program) -> tuple[str, tuple[str, ...]]:
        work = tmp_path / program.path.stem
        work.mkdir()
        return program.name, povray_text.run_povray(program.path, work, program.switches).debug

    with ThreadPoolExecutor(8) as pool:
        printed = dict(pool.map(run, BY_FOLDER[folder]))
    assert printed == {program.name: program.expected for program in BY_FOLDER[folder]}
