"""From Python: a scene in, a NumPy array out.

>>> import minipov
>>> minipov.render(text="camera { location -4*z } sphere { 0, 1 pigment { rgb 1 } }", width=4, height=3).shape
(3, 4, 3)
"""

from __future__ import annotations

import tempfile
import warnings
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Literal, TypeAlias, cast

import numpy as np
from numpy.typing import NDArray

from minipov.diagnostics import not_rendered
from minipov.image_format import FileFormat
from minipov.image_output import stored_channels
from minipov.include_path import library_folders
from minipov.interpreter import Message, Messages, Options, load, load_text
from minipov.interpreter.errors import where
from minipov.pipeline import load_image_file, start, trace
from minipov.tracer.scene import Scene
from minipov.tracer.settings import Antialiasing, RenderSettings

Encoding: TypeAlias = Literal["srgb", "linear"]


class SceneWarning(UserWarning):
    """What a scene, or its interpreter, warns of."""


def render(
    scene: str | Path | Scene | None = None,
    *,
    text: str | None = None,
    files: Mapping[str, str | bytes] | None = None,
    width: int = 800,
    height: int = 600,
    antialias: float | Antialiasing | None = None,
    quality: int = 9,
    alpha: bool = False,
    encoding: Encoding = "srgb",
    clock: float | None = None,
    declares: Mapping[str, float | str] | None = None,
    library_paths: Sequence[str | Path] = (),
    threads: int = 0,
    on_message: Callable[[Message], None] | None = None,
    on_progress: Callable[[float], None] | None = None,
) -> NDArray[np.float32 | np.uint8]:
    """Render a scene.

    Args:
        scene: the path of a scene file, or a scene built of the objects in `minipov.tracer`. With ``text``, the name
            by which messages call it.
        text: the scene itself, in SDL.
        files: files that are nowhere on disk, by the names that the scene uses: str for includes, bytes for images
            and fonts.
        width: pixels in a row.
        height: rows.
        antialias: the threshold of antialiasing, as in ``+A0.3``, or all its settings; None is off.
        quality: 0 to 11, as in ``+Q9``.
        alpha: keep the background transparent; the array has a fourth channel.
        encoding: "srgb" gives the 8-bit codes of a PNG file; "linear" gives linear light as float32, beyond 1 where it
            is brighter than white, and multiplied by alpha.
        clock: the value of ``clock``.
        declares: values that the scene finds declared.
        library_paths: further folders for includes, images and fonts.
        threads: how many to render with; 0 is one per core. The picture does not depend on it.
        on_message: takes warnings and what ``#debug`` prints; None passes warnings on as `SceneWarning`.
        on_progress: takes the finished share, 0 to 1; an exception from it ends the render.

    Returns:
        The picture, (height, width, 3 or 4), row 0 at the top: uint8, or float32 for "linear".

    Raises:
        SdlError: a mistake in the scene; ``message``, ``place`` (file, line, column), ``hint`` and ``stack`` tell.
        ValueError: neither a scene nor a text is given, or the picture has no pixels.
    """
    if width < 1 or height < 1:
        raise ValueError(f"a picture of {width} by {height} pixels cannot be made")
    messages = Messages(sink=on_message or _warn)
    with tempfile.TemporaryDirectory(prefix="minipov-files-") as folder:
        options = Options(
            width=width,
            height=height,
            library_paths=(Path(folder), *map(Path, library_paths), *library_folders()),
            declares=dict(declares or {}),
            clock=clock or 0.0,
            clock_on=clock is not None,
            quality=quality,
            files=_sources(files or {}, Path(folder)),
            load_image=load_image_file,
        )
        graph = _scene(scene, text, options, messages)
    settings = RenderSettings(
        width=width,
        height=height,
        antialiasing=Antialiasing(threshold=antialias) if isinstance(antialias, float | int) else antialias,
        quality=quality,
        threads=threads,
        alpha=alpha,
    )
    job = start(graph, settings)
    for feature, place in job.unsupported:
        messages.warn(not_rendered(feature, place))
    result = trace(job, on_progress or (lambda share: None))
    file = FileFormat("png" if encoding == "srgb" else "exr", alpha=alpha)
    channels = stored_channels(result.pixels.astype(np.float64), graph.settings.assumed_gamma, file)
    return cast("NDArray[np.float32 | np.uint8]", channels)


def _scene(scene: str | Path | Scene | None, text: str | None, options: Options, messages: Messages) -> Scene:
    if isinstance(scene, Scene):
        return scene
    if text is not None:
        return load_text(text, str(scene or "scene.pov"), options, messages)
    if scene is None:
        raise ValueError("give a scene or a text")
    return load(scene, options, messages)


def _sources(files: Mapping[str, str | bytes], folder: Path) -> dict[str, bytes]:
    """Give the texts back as sources, and put the rest where the libraries for images and fonts can read it."""
    for name, content in files.items():
        if isinstance(content, bytes):
            path = folder / name
            if not path.resolve().is_relative_to(folder.resolve()):
                raise ValueError(f"files: {name} leads out of its folder")
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
    return {name: content.encode() for name, content in files.items() if isinstance(content, str)}


def _warn(message: Message) -> None:
    if message.kind == "warning":
        warnings.warn(f"{where(message.place)}{message.text}", SceneWarning, stacklevel=2)
