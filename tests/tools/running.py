"""Running `minipov` as a user does, and a stand-in for POV-Ray that is quick and paints what a test wants."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path

MINIPOV = (sys.executable, "-P", "-m", "minipov")
"""-P: the folder a test runs in holds no modules."""

SMALL = ("+W16", "+H12")

WHITE = """#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 1 }
sphere { -9*z, 1 }
"""
"""A scene whose picture is known to the bit; its object is behind the camera."""

_FAKE_POVRAY = """#!{python}
import sys
from pathlib import Path
from PIL import Image
if "--version" in sys.argv:
    print("POV-Ray 3.7.0.fake")
    sys.exit()
given = {{word[:2]: word[2:] for word in sys.argv[1:]}}
if "refuse" in Path(given["+I"]).read_text():
    sys.exit("Parse Error: refused")
Image.new("RGB", (int(given["+W"]), int(given["+H"])), {color!r}).save(given["+O"])
"""

_EMPTY_HOME = tempfile.mkdtemp(prefix="minipov-tests-home-")
_CACHE = str(Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")))
_CODE = os.environ.get("MINIPOV_CACHE", str(Path(_CACHE) / "minipov" / "code"))


def minipov(
    *arguments: str | Path, cwd: Path, env: Mapping[str, str] | None = None, stdin: bytes = b"", timeout: float = 60
) -> subprocess.CompletedProcess[bytes]:
    """Run the program in ``cwd`` and wait for it. A user's own INI files do not count."""
    return subprocess.run(
        [*MINIPOV, *map(str, arguments)],
        cwd=cwd,
        env=environment(env),
        input=stdin,
        capture_output=True,
        timeout=timeout,
    )


def environment(env: Mapping[str, str] | None = None) -> dict[str, str]:
    """The environment of a run: this one's, without what would change minipov's options, and with ``env``."""
    kept = {name: value for name, value in os.environ.items() if name not in ("POVINI", "POVINC", "POVRAY_BINARY")}
    return kept | {"HOME": _EMPTY_HOME, "XDG_CACHE_HOME": _CACHE, "MINIPOV_CACHE": _CODE} | dict(env or {})


def fake_povray(folder: Path, color: tuple[int, int, int]) -> dict[str, str]:
    """Make a program that paints every scene in ``color``; return the environment in which it is POV-Ray."""
    program = folder / "fake-povray"
    program.write_text(_FAKE_POVRAY.format(python=sys.executable, color=color))
    program.chmod(0o755)
    return {"POVRAY_BINARY": str(program), "XDG_CACHE_HOME": str(folder / "cache")}


def said(run: subprocess.CompletedProcess[bytes]) -> str:
    """What a run wrote to standard error."""
    return run.stderr.decode()
