"""SDL: ``assumed_gamma``, and what holds without it."""

from __future__ import annotations

from typing import Final

from minipov.interpreter.context import Context
from minipov.tracer.settings import Gamma

GAMMA_VERSION: Final = 3.7
"""Since this version a scene without ``assumed_gamma`` works in linear light; before, there is no gamma handling."""


def working_gamma(context: Context) -> Gamma:
    """The working space as far as the scene has said by now."""
    if context.scene.gamma_was_set:
        return context.scene.settings.assumed_gamma
    return 1.0 if context.version >= GAMMA_VERSION else None
