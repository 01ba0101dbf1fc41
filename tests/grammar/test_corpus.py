"""Every scene and include file that POV-Ray ships parses, but for the one that POV-Ray itself rejects."""

from __future__ import annotations

from pathlib import Path

import pytest
from minipov.grammar import SdlSyntaxError, parse
from minipov.grammar.text import decode

FOLDERS = (Path("/usr/share/doc/povray/examples"), Path("/usr/share/povray-3.7/include"))
FILES = sorted(f for d in FOLDERS for f in d.rglob("*") if f.suffix in {".pov", ".inc", ".mac", ".map"})
REJECTED_BY_POVRAY = {"__empty.pov"}


def test_the_corpus_is_installed() -> None:
    assert len(FILES) > 400, "install povray-includes and povray-examples"


@pytest.mark.parametrize("folder", sorted({f.parent for f in FILES}), ids=str)
def test_files_parse(folder: Path) -> None:
    for file in FILES:
        if file.parent == folder and file.name not in REJECTED_BY_POVRAY:
            assert parse(decode(file.read_bytes()), str(file)).items


def test_rejected_files_are_still_rejected() -> None:
    for file in FILES:
        if file.name in REJECTED_BY_POVRAY:
            with pytest.raises(SdlSyntaxError):
                parse(decode(file.read_bytes()), str(file))
