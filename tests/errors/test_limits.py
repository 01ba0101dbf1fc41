"""Counts beyond all reason become the largest that make sense, with a warning; what is no number does no harm."""

from __future__ import annotations

import pytest
from minipov.interpreter import Messages, load_text

HEAD = "#version 3.7; global_settings { assumed_gamma 1 }\n"
BEYOND = {
    "blur_samples": "camera { aperture 1 blur_samples 1e9 }",
    "area_light": "light_source { 0, 1 area_light x, y, 1e5, 1e5 }",
    "radiosity": "global_settings { radiosity { count 1e300 } }",
    "mandel": "sphere { 0, 1 pigment { mandel 1e9 } }",
    "julia_fractal": "julia_fractal { 0 max_iteration 1e9 }",
    "dispersion_samples": "sphere { 0, 1 interior { dispersion_samples 1e9 } }",
    "aa_level": "media { aa_level 1e9 }",
    "max_trace_level": "global_settings { photons { max_trace_level 1e9 } }",
    "intervals": "media { intervals -5 }",
}
NO_NUMBER = (
    "global_settings { max_trace_level 0/0 }",
    "camera { aperture 1 blur_samples 0/0 }",
    "media { samples 0/0 }",
)


def warnings(scene: str) -> list[str]:
    said: list[str] = []
    load_text(HEAD + scene, messages=Messages(sink=lambda message: said.append(message.text)))
    return said


@pytest.mark.parametrize("name", BEYOND)
def test_counts_beyond_their_limits(name: str) -> None:
    assert any("is beyond" in text and "taken as" in text for text in warnings(BEYOND[name]))


@pytest.mark.parametrize("scene", NO_NUMBER)
def test_counts_that_are_no_numbers(scene: str) -> None:
    assert any("division" in text.lower() for text in warnings(scene))
