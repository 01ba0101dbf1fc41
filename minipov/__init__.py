"""Renders POV-Ray's scenes: ``minipov scene.pov`` on the command line, ``minipov.render`` from Python."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from minipov.api import SceneWarning, render
    from minipov.interpreter import Message, SdlError

__version__ = "0.1.0"

__all__ = ["Message", "SceneWarning", "SdlError", "__version__", "render"]

_HOMES = {
    "Message": "minipov.interpreter",
    "SceneWarning": "minipov.api",
    "SdlError": "minipov.interpreter",
    "render": "minipov.api",
}


def __getattr__(name: str) -> Any:
    """Load what is asked for; the command line does not wait for it."""
    if name in _HOMES:
        return getattr(importlib.import_module(_HOMES[name]), name)
    raise AttributeError(f"module 'minipov' has no attribute {name!r}")
