"""What 3.8 added, against the same thing in other words: POV-Ray 3.7 has none of it."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import minipov

ROOM = """
#version 3.8;
global_settings { assumed_gamma 1 }
camera { location <1.5, 2, -5> look_at 0 angle 40 }
light_source { <2, 4, -3>, rgb 1 }
plane { y, -1.6 pigment { checker rgb 0.9 rgb 0.3 } }
#default { finish { ambient 0.1 diffuse 0.8 phong 0.5 } }
"""


def picture(objects: str) -> NDArray[np.int64]:
    return np.asarray(minipov.render(text=ROOM + objects, width=64, height=48)).astype(np.int64)


@pytest.mark.parametrize(
    ("added", "known"),
    [
        # An arc of radius 1 whose centre lies 0.6 beyond the axis: where two balls overlap, turned about their line.
        (
            "lemon { <0, -0.8, 0>, 0, <0, 0.8, 0>, 0, 1 pigment { rgb 1 } }",
            "torus { 0.6, 1 intersection pigment { rgb 1 } }",
        ),
        # Nearly straight arcs.
        (
            "lemon { <0, -1, 0>, 0.7, <0.5, 1, 0>, 0.3, 1e5 pigment { rgb <1, 0.5, 0.2> } }",
            "cone { <0, -1, 0>, 0.7, <0.5, 1, 0>, 0.3 pigment { rgb <1, 0.5, 0.2> } }",
        ),
        (
            "lemon { <0, -1, 0>, 0.7, <0.5, 1, 0>, 0.3, 1e5 open pigment { rgb <1, 0.5, 0.2> } }",
            "cone { <0, -1, 0>, 0.7, <0.5, 1, 0>, 0.3 open pigment { rgb <1, 0.5, 0.2> } }",
        ),
        ("torus { 1, 0.3 difference pigment { rgb 1 } }", "torus { 1, 0.3 pigment { rgb 1 } }"),
        (
            "torus { 0.4, 0.8 union pigment { rgb 1 } }",
            "torus { 0.4, 0.8 pigment { rgb 1 } }",
        ),
        (
            "difference { torus { 0.4, 0.8 merge } box { <-2, -2, -2>, <2, 2, 0> } pigment { rgb 1 } }",
            "difference { merge { torus { 0.4, 0.8 difference } torus { 0.4, 0.8 intersection } } "
            "box { <-2, -2, -2>, <2, 2, 0> } pigment { rgb 1 } }",
        ),
        # Points that come again: far from the seams nothing has changed, and moved by a period nothing has.
        (
            "box { -1, 1 pigment { crackle repeat 100 translate -50 } }",
            "box { -1, 1 pigment { crackle translate -50 } }",
        ),
        (
            "box { -1, 1 pigment { crackle repeat <2, 3, 0> scale 0.2 } }",
            "box { -1, 1 pigment { crackle repeat <2, 3, 0> translate <2, -3, 0> scale 0.2 } }",
        ),
        (
            "box { -1, 1 pigment { user_defined { function { x } function { 0.5 } function { z } } } }",
            "box { -1, 1 pigment { average pigment_map { "
            "[1 function { x*(x > 0) } color_map { [0 rgb 0] [1 rgb 3*x] }] "
            "[1 function { 0.5 } color_map { [0 rgb 0] [1 rgb 3*y] }] "
            "[1 function { z*(z > 0) } color_map { [0 rgb 0] [1 rgb 3*z] }] } } }",
        ),
    ],
)
def test_additions_say_what_older_words_do(added: str, known: str) -> None:
    ours, expected = picture(added), picture(known)
    assert (expected != picture("")).any(axis=2).mean() > 0.02
    assert (np.abs(ours - expected).max(axis=2) > 2).mean() < 0.01
