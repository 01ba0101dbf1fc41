"""`minipov.render`: files, texts, in-memory files, encodings, messages, mistakes."""

from __future__ import annotations

import io
import warnings
from pathlib import Path

import numpy as np
import pytest
from minipov.tracer.scene import Scene
from PIL import Image

import minipov

HEAD = "#version 3.7; global_settings { assumed_gamma 1 }\n"
GREY = HEAD + "background { rgb 0.5 } sphere { -9*z, 1 }"


def test_a_file(tmp_path: Path) -> None:
    (tmp_path / "grey.pov").write_text(GREY)
    for path in (tmp_path / "grey.pov", str(tmp_path / "grey.pov")):
        picture = minipov.render(path, width=8, height=6)
        assert picture.shape == (6, 8, 3)
        assert picture.dtype == np.uint8
        assert np.all(picture == 188)


def test_a_text() -> None:
    assert np.all(minipov.render(text=GREY, width=8, height=6) == 188)


def test_linear_light_goes_beyond_white() -> None:
    picture = minipov.render(text=GREY.replace("0.5", "<0.25, 1, 4>"), width=8, height=6, encoding="linear")
    assert picture.dtype == np.float32
    assert np.allclose(picture, [0.25, 1, 4])


def test_linear_light_from_another_working_space() -> None:
    text = GREY.replace("assumed_gamma 1", "assumed_gamma 2")
    assert np.allclose(minipov.render(text=text, width=8, height=6, encoding="linear"), 0.25)


def test_alpha() -> None:
    picture = minipov.render(text=HEAD + "sphere { -9*z, 1 }", width=8, height=6, alpha=True)
    assert picture.shape == (6, 8, 4)
    assert np.all(picture[..., 3] == 0)


def test_includes_and_images_from_memory() -> None:
    stored = io.BytesIO()
    Image.new("RGB", (2, 2), (255, 0, 0)).save(stored, "PNG")
    text = (
        HEAD
        + """
#include "size.inc"
camera { orthographic location -5*z right 2*x up 2*y }
box { -Size, Size pigment { image_map { png "red.png" } } finish { emission 1 diffuse 0 ambient 0 } }
"""
    )
    files: dict[str, str | bytes] = {"size.inc": "#declare Size = 3;", "red.png": stored.getvalue()}
    picture = minipov.render(text=text, files=files, width=8, height=6)
    assert np.all(picture == (255, 0, 0))


def test_files_stay_in_their_folder() -> None:
    with pytest.raises(ValueError, match="leads out"):
        minipov.render(text=GREY, files={"../out.png": b""})


def test_values_from_outside() -> None:
    text = HEAD + "background { rgb Bright * clock * (clock_on = 1) } sphere { -9*z, 1 }"
    picture = minipov.render(text=text, declares={"Bright": 0.5}, clock=0.5, encoding="linear", width=8, height=6)
    assert np.allclose(picture, 0.25)


def test_a_scene_built_in_python() -> None:
    assert minipov.render(Scene(background=(0.5, 0.5, 0.5, 0, 0)), width=8, height=6).shape == (6, 8, 3)


def test_antialiasing_changes_edges_only() -> None:
    text = HEAD + "camera { location -3*z } sphere { 0, 1 pigment { rgb 1 } finish { emission 1 diffuse 0 ambient 0 } }"
    plain, smooth = (minipov.render(text=text, width=32, height=24, antialias=a) for a in (None, 0.1))
    assert set(np.unique(plain)) == {0, 255}
    assert len(np.unique(smooth)) > 4


def test_the_picture_does_not_depend_on_threads() -> None:
    text = HEAD + "light_source { <1, 2, -3> 1 } camera { location -3*z } sphere { 0, 1 pigment { granite } }"
    one, two = (minipov.render(text=text, width=64, height=48, threads=threads) for threads in (1, 2))
    assert np.array_equal(one, two)


def test_a_mistake_tells_where() -> None:
    with pytest.raises(minipov.SdlError) as caught:
        minipov.render("scene.pov", text="sphere { 0, 1 }\nbox { 0, Sise }", width=8, height=6)
    assert caught.value.place == ("scene.pov", 2, 10)
    assert "Sise" in caught.value.message


def test_a_mistake_in_an_include_from_memory() -> None:
    with pytest.raises(minipov.SdlError) as caught:
        minipov.render(text='#include "part.inc"', files={"part.inc": "sphere {"}, width=8, height=6)
    assert caught.value.place[:2] == ("part.inc", 1)


def test_warnings_are_pythons() -> None:
    with pytest.warns(minipov.SceneWarning, match="scene.pov:1:1: careful"):
        minipov.render(text='#warning "careful"\n' + GREY, width=8, height=6)


def test_messages_go_where_they_are_wanted() -> None:
    seen: list[minipov.Message] = []
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        minipov.render(text='#debug "one\\n" #warning "two"\n' + GREY, width=8, height=6, on_message=seen.append)
    assert [(message.kind, message.text.strip()) for message in seen] == [("debug", "one"), ("warning", "two")]


def test_progress_reaches_the_end_and_can_stop() -> None:
    shares: list[float] = []
    minipov.render(text=GREY, width=8, height=6, on_progress=shares.append)
    assert shares == sorted(shares)
    assert shares[-1] == 1.0

    def stop(share: float) -> None:
        raise InterruptedError

    with pytest.raises(InterruptedError):
        minipov.render(text=GREY, width=8, height=6, on_progress=stop)


@pytest.mark.parametrize("size", [(0, 6), (8, -1)])
def test_a_picture_needs_pixels(size: tuple[int, int]) -> None:
    with pytest.raises(ValueError, match="cannot be made"):
        minipov.render(text=GREY, width=size[0], height=size[1])


def test_something_has_to_be_rendered() -> None:
    with pytest.raises(ValueError, match="give a scene or a text"):
        minipov.render()


def test_only_what_is_public_is_there() -> None:
    assert set(minipov.__all__) <= {*dir(minipov), "Message", "SceneWarning", "SdlError", "render"}
    with pytest.raises(AttributeError, match="nothing"):
        _ = minipov.nothing
