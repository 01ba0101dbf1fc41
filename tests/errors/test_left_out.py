"""What the tracer cannot render is named once, and the rest of the scene renders."""

from __future__ import annotations

import pytest

import minipov

HEAD = """#version 3.8;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
light_source { -10*z, 1 }
"""
LEFT_OUT = {
    "anisotropy of subsurface": "global_settings { subsurface { samples 2, 2 } }"
    " #default { finish { subsurface { translucency 0.5 anisotropy 0.3 } } }",
    "blend_mode of a colour map": "#default { pigment { gradient x"
    " color_map { blend_mode 2 [0 rgb 0.5] [1 rgb 1] } } }",
    "files of photons": 'global_settings { photons { count 100 save_file "photons" } }',
    "fresnel of a finish": "#default { finish { fresnel on } }",
    "radiosity under surfaces": "global_settings { subsurface { samples 2, 2 radiosity on } }",
    "use_alpha of a finish": "#default { finish { use_alpha on } }",
}


@pytest.mark.parametrize("feature", LEFT_OUT)
def test_what_is_left_out_is_named_once(feature: str) -> None:
    said: list[str] = []
    scene = f"{HEAD}{LEFT_OUT[feature]} sphere {{ -x, 1 }} sphere {{ x, 1 }}"
    picture = minipov.render(text=scene, width=8, height=6, on_message=lambda message: said.append(message.text))
    assert [text for text in said if "not rendered yet" in text] == [f"{feature}: not rendered yet"]
    assert picture.max() > 0
