"""One picture, whatever finds the hits, however many threads render it, in one piece or several; and stopping early."""

from __future__ import annotations

import time
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from minipov.interpreter import Messages, load_text
from minipov.interpreter.context import Options
from minipov.tracer.render import RenderJob, render
from minipov.tracer.scene import Scene
from minipov.tracer.settings import ACCELERATORS, Accelerator, Antialiasing, RenderSettings
from numpy.typing import NDArray

SETTINGS = RenderSettings(width=44, height=36, threads=1)
ANTIALIASED = replace(SETTINGS, antialiasing=Antialiasing(method=2, threshold=0.1, depth=2, jitter=1.0))

STILL_LIFE = """
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -7> look_at <0, 0.6, 0> angle 42 aperture 0.1 focal_point 0 blur_samples 7 }
light_source { <5, 8, -6>, rgb 1 area_light 3*x, 3*z, 4, 4 adaptive 1 jitter }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.4, 0.5> } finish { reflection 0.1 crand 0.1 } }
#for (I, 0, 24)
  sphere { <mod(I, 5) - 2, 0.3, div(I, 5) - 2>, 0.3
    #if (mod(I, 2) = 0) pigment { rgbf <0.9, 1, 0.9, 0.9> } interior { ior 1.4 }
    #else pigment { rgb <0.9, 0.3, 0.2> } #end }
#end
difference {
  box { <-3, 0, 2.4>, <3, 2, 2.6> }
  #for (I, 0, 9) cylinder { <I*0.5 - 2.25, 1, 2>, <I*0.5 - 2.25, 1, 3>, 0.2 } #end
  pigment { rgb <0.5, 0.6, 0.9> }
}
"""

SLOW_PIXELS = """
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 250 adc_bailout 0 }
camera { location <0, 0, -0.9> look_at <0, 0, 1> }
light_source { <0, 0.5, 0>, rgb 1 area_light x*0.1, y*0.1, 33, 33 adaptive 9 }
sphere { 0, 1 pigment { rgbt <1, 1, 1, 0.5> } finish { reflection 0.9 } interior { ior 1.5 } }
sphere { <0, 0, 0.5>, 0.2 pigment { rgbt <1, 1, 1, 0.5> } finish { reflection 0.9 } interior { ior 1.5 } }
"""


@cache
def scene(text: str) -> Scene:
    return load_text(text, "test.pov", Options(), Messages())


def picture(settings: RenderSettings) -> NDArray[np.float32]:
    return render(scene(STILL_LIFE), settings).pixels


@cache
def expected() -> NDArray[np.float32]:
    return picture(ANTIALIASED)


@pytest.mark.parametrize("accelerator", ACCELERATORS)
def test_every_accelerator_gives_the_same_bits(accelerator: Accelerator) -> None:
    assert np.array_equal(picture(replace(ANTIALIASED, accelerator=accelerator)), expected())


@pytest.mark.parametrize("threads", [2, 3, 5])
def test_threads_do_not_change_the_picture(threads: int) -> None:
    assert np.array_equal(picture(replace(ANTIALIASED, threads=threads)), expected())


def test_a_part_is_cut_out_of_the_whole() -> None:
    part = picture(replace(SETTINGS, columns=(13, 40), rows=(7, 34)))
    whole = picture(SETTINGS)
    assert np.array_equal(part[7:34, 13:40], whole[7:34, 13:40])
    assert not part[:7].any() and not part[34:].any() and not part[:, :13].any() and not part[:, 40:].any()


def test_accelerators_test_fewer_objects_than_all() -> None:
    def tests(accelerator: Accelerator) -> int:
        return sum(render(scene(STILL_LIFE), replace(SETTINGS, accelerator=accelerator)).statistics.tests.values())

    linear, spheres, octree = tests("linear"), tests("spheres"), tests("octree")
    assert octree < spheres < linear


def test_cancel_stops_within_a_pixel() -> None:
    job = RenderJob(scene(SLOW_PIXELS), replace(SETTINGS, width=32, height=32))
    time.sleep(0.2)
    assert not job.finished, "the scene is not slow enough for this test"
    started = time.perf_counter()
    job.cancel()
    result = job.finish()
    assert time.perf_counter() - started < 1.0
    assert not result.complete


def test_a_snapshot_holds_finished_tiles_only() -> None:
    job = RenderJob(scene(SLOW_PIXELS), replace(SETTINGS, width=32, height=32))
    assert not job.snapshot().any()
    job.cancel()
    job.finish()
