"""``Continue_Trace=on``, switch ``+C``: what an interrupted render leaves beside its picture, to go on from.

The file ``picture.png.minipov-state`` holds the finished pixels and what they belong to: the scene's text and the
options that change the picture. It is written when a render is interrupted, and now and then in a long one, so that a
crash loses little; a finished picture takes it away.
"""

from __future__ import annotations

import hashlib
import time
import zipfile
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from minipov.frames import Frame
from minipov.tracer.settings import RenderSettings

SAVE_SECONDS = 60.0


class Unfinished:
    """The state of one picture on disk."""

    def __init__(self, picture: Path, scene: bytes, frame: Frame, settings: RenderSettings) -> None:
        self.path = picture.with_name(picture.name + ".minipov-state")
        what = f"{frame}{replace(settings, threads=0)}".encode()
        self._key = hashlib.blake2b(scene + b"\0" + what, digest_size=20).hexdigest()
        self._saved = time.monotonic()

    def read(self) -> NDArray[np.float32] | None:
        """The pixels of an earlier attempt at the same picture, NaN where there are none; None without one."""
        try:
            with np.load(self.path, allow_pickle=False) as stored:
                return stored["pixels"] if str(stored["key"]) == self._key else None
        except (OSError, ValueError, KeyError, zipfile.BadZipFile):
            return None

    def save(self, pixels: NDArray[np.float32]) -> None:
        """Put the state down; where that fails there is nothing to go on from, and that is all."""
        part = self.path.with_name(self.path.name + ".part")
        try:
            with part.open("wb") as file:
                np.savez(file, pixels=pixels, key=np.array(self._key))
            part.replace(self.path)
        except OSError:
            part.unlink(missing_ok=True)
        self._saved = time.monotonic()

    @property
    def is_due(self) -> bool:
        """Whether the state was not saved for a while."""
        return time.monotonic() - self._saved > SAVE_SECONDS

    def remove(self) -> None:
        """Take the state away: the picture is complete."""
        self.path.unlink(missing_ok=True)
