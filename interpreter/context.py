"""What a running scene knows: options from outside, state that directives change, and the scene being built."""

from __future__ import annotations

from collections.abc import Callable
from contextvars import ContextVar
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final, Protocol

from minipov.interpreter.errors import Messages
from minipov.tracer.atmosphere import Fog, Rainbow, SkySphere
from minipov.tracer.camera import Camera
from minipov.tracer.image import Image, ImagePurpose
from minipov.tracer.interior import Media
from minipov.tracer.lights import LightSource
from minipov.tracer.objects import Object
from minipov.tracer.settings import Gamma, GlobalSettings
from minipov.tracer.texture import PlainTexture, Texture
from minipov.tracer.values import Rgbft


class ImageLoader(Protocol):
    """Reads an image file; ``kind`` is SDL's file type word (``png``), or "" to tell by content.

    ``gamma`` None means the file format's default in the scene's ``version`` for pictures read for their colours, and
    the stored numbers for others. Colours come back in the ``working`` space. Raises OSError for what cannot be read.
    """

    def __call__(
        self, path: Path, kind: str, *, gamma: Gamma, purpose: ImagePurpose, working: Gamma, version: float
    ) -> Image: ...


@dataclass(frozen=True, slots=True)
class Options:
    """What the caller decides about a run; frame numbers and clocks as POV-Ray's variables of the same name.

    ``files`` are sources given by the caller, by name. Scenes may write files below the ``writable`` folders only; None
    stands for the working directory and the system's folder of temporary files.
    """

    width: int = 320
    height: int = 240
    library_paths: tuple[Path, ...] = ()
    declares: dict[str, float | str] = field(default_factory=dict)
    clock: float = 0.0
    clock_on: bool = False
    clock_delta: float = 0.0
    frame_number: int = 0
    initial_frame: int = 0
    final_frame: int = 0
    initial_clock: float = 0.0
    final_clock: float = 0.0
    version: float | None = None
    quality: int = 9
    files: dict[str, bytes] = field(default_factory=dict)
    load_image: ImageLoader | None = None
    writable: tuple[Path, ...] | None = None


@dataclass(slots=True)
class SceneBuilder:
    """The scene as collected so far, in source order."""

    objects: list[Object] = field(default_factory=list)
    lights: list[LightSource] = field(default_factory=list)
    camera: Camera | None = None
    background: Rgbft | None = None
    fogs: list[Fog] = field(default_factory=list)
    rainbows: list[Rainbow] = field(default_factory=list)
    sky_sphere: SkySphere | None = None
    media: list[Media] = field(default_factory=list)
    settings: GlobalSettings = field(default_factory=GlobalSettings)
    gamma_was_set: bool = False
    noise_was_set: bool = False
    charset: str = "ascii"


SECOND_NOISE_SINCE: Final = 3.5

UNSAID_VERSION: Final = 3.62
"""The version that holds for a scene without ``#version`` (its variable ``version`` reads 3.7 all the same)."""


@dataclass(slots=True)
class Context:
    """Handed to every construct. ``find_file`` searches as ``#include`` does, with a list of extensions to try."""

    options: Options
    messages: Messages
    find_file: Callable[[str, tuple[str, ...]], Path | None]
    scene: SceneBuilder = field(default_factory=SceneBuilder)
    version: float = UNSAID_VERSION
    version_was_set: bool = False
    default_was_set: bool = False
    default_texture: Texture = field(default_factory=PlainTexture)
    default_camera: Any = None
    default_radiosity_importance: float | None = None

    @property
    def noise_generator(self) -> int:
        """The scene's noise generator: before version 3.5 the first, unless it says otherwise."""
        old = self.version < SECOND_NOISE_SINCE and not self.scene.noise_was_set
        return 1 if old else self.scene.settings.noise_generator


_current: ContextVar[Context] = ContextVar("minipov_context")


def current_context() -> Context:
    """The context of the scene that runs in this thread."""
    return _current.get()


def set_current_context(context: Context) -> None:
    """Make ``context`` that of this thread's running scene."""
    _current.set(context)
