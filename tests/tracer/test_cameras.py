"""``camera { user_defined ... }`` against the built-in camera that its functions describe: POV-Ray 3.7 has none."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import minipov

ROOM = """
#version 3.8;
global_settings { assumed_gamma 1 }
light_source { <2, 4, -3>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9 rgb 0.3 } }
sphere { <0.8, 0, 1>, 1 pigment { rgb <1, 0.3, 0.2> } }
"""
PERSPECTIVE = "camera { location <0, 0.5, -4> right 1.33*x direction <0, -0.1, 1>"
ORIGIN = "location { function { 0 } function { 0.5 } function { -4 } }"
DIRECTION = "direction { function { 1.33*x } function { y - 0.1 } function { 1 } }"


def picture(camera: str) -> NDArray[np.uint8]:
    return np.asarray(minipov.render(text=ROOM + camera, width=48, height=36))


@pytest.mark.parametrize(
    ("functions", "built_in"),
    [
        (f"camera {{ user_defined {ORIGIN} {DIRECTION} }}", PERSPECTIVE + "}"),
        (f"camera {{ user_defined location <0, 0.5, -4> {DIRECTION} }}", PERSPECTIVE + "}"),
        (
            "camera { user_defined location <0, 0.5, -4> direction { function (u, v) { 1.33*u }, "
            "function (u, v) { v - 0.1 }, function (u, v) { 1 } } }",
            PERSPECTIVE + "}",
        ),
        (
            "camera { user_defined location { function { 4*x } function { 3*y } function { -4 } } direction z }",
            "camera { orthographic location -4*z right 4*x up 3*y direction z }",
        ),
        (
            f"camera {{ user_defined {ORIGIN} {DIRECTION} rotate 20*y scale <1, 1.2, 1> translate 0.1*x }}",
            PERSPECTIVE + "rotate 20*y scale <1, 1.2, 1> translate 0.1*x }",
        ),
        (
            f"#declare C = camera {{ user_defined {ORIGIN} {DIRECTION} rotate 20*y }} camera {{ C translate 0.1*x }}",
            PERSPECTIVE + "rotate 20*y translate 0.1*x }",
        ),
    ],
)
def test_functions_say_what_a_built_in_camera_does(functions: str, built_in: str) -> None:
    ours, expected = picture(functions), picture(built_in)
    assert len(np.unique(expected)) > 20
    assert np.abs(ours.astype(int) - expected).max() <= 2


def test_nothing_is_seen_where_the_functions_give_no_direction() -> None:
    halves = "direction { function { ln(x) } function { y } function { 1 } }"
    seen = picture(f"camera {{ user_defined location -4*z {halves} }} background {{ rgb 1 }}")
    assert not seen[:, :24].any() and seen[:, 25:].any()


def test_functions_belong_to_user_defined_cameras() -> None:
    with pytest.raises(minipov.SdlError, match="user_defined"):
        picture(f"camera {{ perspective {ORIGIN} }}")
