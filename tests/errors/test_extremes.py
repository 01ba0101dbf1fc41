"""Shapes of nothing, of no number and beyond all measure: each renders, or is refused, in reasonable time."""

from __future__ import annotations

import time

import pytest
from minipov.interpreter import SdlError

import minipov

HEAD = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.3, 0.2, -4> look_at 0 }
light_source { <3, 5, -9>, 1 }
"""

# What stands at each %s is exchanged for each of the values, the others being ORDINARY.
SHAPES = {
    "sphere": "sphere { <%s, %s, 0>, %s }",
    "box": "box { <%s, 0, -1>, <%s, %s, 1> }",
    "cone": "cone { <0, %s, 0>, %s, <0, 1, 0>, %s }",
    "cylinder": "cylinder { <0, %s, 0>, <%s, 1, 0>, %s }",
    "disc": "disc { 0, <%s, 0, -1>, %s, %s }",
    "plane": "plane { <0, %s, %s>, %s }",
    "torus": "torus { %s, %s rotate %s*x }",
    "torus spindle": "torus { %s, %s difference scale %s }",
    "lemon": "lemon { 0, %s, y, %s, %s }",
    "ovus": "ovus { %s, %s scale %s }",
    "lathe linear": "lathe { linear_spline 3 <0, %s>, <%s, 0>, <1, %s> }",
    "lathe cubic": "lathe { cubic_spline 5 <0, %s>, <%s, 0>, <1, %s>, <0.5, 1>, <0.2, 1> }",
    "lathe quadratic": "lathe { quadratic_spline 5 <0, %s>, <%s, 0>, <1, %s>, <0.5, 1>, <0.2, 1> }",
    "lathe bezier": "lathe { bezier_spline 4 <0, %s>, <%s, 0>, <1, %s>, <0.5, 1> }",
    "sor": "sor { 5 <0, 0>, <%s, 0.1>, <1, %s>, <0.5, %s>, <0.2, 2> }",
    "prism": "prism { linear_sweep linear_spline %s, %s, 4, <0, 0>, <1, 0>, <%s, 1>, <0, 0> }",
    "prism conic": "prism { conic_sweep cubic_spline %s, %s, 6, <0, 0>, <1, 0>, <%s, 1>, <0, 0>, <1, 0>, <1, 1> }",
    "blob": "blob { threshold %s sphere { 0, %s, %s } cylinder { 0, y, %s, 1 } }",
    "superellipsoid": "superellipsoid { <%s, %s> scale %s }",
    "sphere_sweep": "sphere_sweep { linear_spline 3 <-1, %s, 0>, %s, 0, 0.3, x, %s }",
    "sphere_sweep b": "sphere_sweep { b_spline 4 <-1, %s, 0>, %s, 0, 0.3, x, %s, <2, 1, 0>, 0.3 }",
    "sphere_sweep cubic": "sphere_sweep { cubic_spline 4 -x, %s, 0, 0.3, x, 0.3, <2, 1, 0>, %s tolerance %s }",
    "bicubic_patch": "bicubic_patch { type 1 flatness %s u_steps 3 v_steps 3 <0, 0, %s>, x, 2*x, 3*x, y, <1, 1, %s>,"
    " <2, 1, 0>, <3, 1, 0>, <0, 2, 0>, <1, 2, 0>, <2, 2, 0>, <3, 2, 0>, 3*y, <1, 3, 0>, <2, 3, 0>, <3, 3, 0> }",
    "bicubic_patch steps": "bicubic_patch { type 0 flatness 0.01 u_steps %s v_steps %s <0, 0, %s>, x, 2*x, 3*x, y,"
    " 1, <2, 1, 0>, <3, 1, 0>, <0, 2, 0>, <1, 2, 0>, <2, 2, 0>, <3, 2, 0>, 3*y, <1, 3, 0>, <2, 3, 0>, <3, 3, 0> }",
    "polygon": "polygon { 4, <0, %s>, <1, %s>, <%s, 1>, <0, 0> }",
    "triangle": "triangle { <0, %s, 0>, <%s, 0, 0>, <1, 1, %s> }",
    "smooth_triangle": "smooth_triangle { 0, <0, %s, %s>, x, <0, %s, -1>, y, -z }",
    "mesh": "mesh { triangle { <0, %s, 0>, <%s, 0, 0>, <1, 1, %s> } }",
    "mesh2": "mesh2 { vertex_vectors { 3, <0, %s, 0>, <%s, 0, 0>, <1, %s, 0> } face_indices { 1, <0, 1, 2> } }",
    "mesh2 indices": "mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <%s, %s, %s> } }",
    "height_field": "height_field { function 8, 8 { pattern { bozo scale %s } } water_level %s scale %s }",
    "julia_fractal": "julia_fractal { <0.1, 0.1, 0.1, 0.1> max_iteration %s precision %s slice <0, 0, 0, 1>, %s }",
    "julia_fractal exp": "julia_fractal { <%s, %s, 0.1, 0.1> hypercomplex exp max_iteration 5 precision %s }",
    "quadric": "quadric { <%s, 1, 1>, <0, %s, 0>, <0, 0, 0>, %s }",
    "cubic": "cubic { <%s, 0, 0, 1, 0, 0, %s, 0, 0, 0, 1, 0, %s, 0, 0, 0, 0, 0, 0, -1> }",
    "quartic": "quartic { <%s, 0, 0, 0, 0, 0, 0, 0, 0, %s, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0,"
    " 0, 0, 1, 0, %s> }",
    "poly": "poly { %s, <1, 0, 0, 0, 0, 0, %s, 0, 0, %s> }",
    "polynomial": "polynomial { 3 xyz(3, 0, 0): %s xyz(0, %s, 0): 1 xyz(0, 0, 0): %s }",
    "isosurface": "isosurface { function { x*x + y*y + z*z - %s } max_gradient %s accuracy %s }",
    "isosurface box": "isosurface { function { x*x + y*y + z*z - 1 } max_gradient %s"
    " contained_by { box { -%s, %s } } }",
    "isosurface evaluate": "isosurface { function { x*x + y*y + z*z - 1 } evaluate %s, %s, %s all_intersections"
    " contained_by { box { -1e6, 1e6 } } }",
    "parametric": "parametric { function { u*%s } function { v } function { u*v } <0, 0>, <%s, %s> accuracy 0.01"
    " contained_by { box { -1e3, 1e3 } } }",
    "parametric accuracy": "parametric { function { u } function { v } function { u*v } <0, 0>, <1, 1> accuracy %s"
    " max_gradient %s precompute %s x, y, z }",
    "text": 'text { ttf "timrom.ttf" "Ab" %s, <%s, 0> scale %s }',
    "difference": "difference { sphere { 0, %s } box { -1, %s } intersection { plane { y, %s } sphere { 0, 1 } } }",
    "merge": "merge { sphere { 0, %s } torus { 1, %s } inverse scale %s }",
    "matrix": "sphere { 0, 1 matrix <1, 0, 0, 0, %s, 0, 0, 0, 1, 0, %s, %s> }",
    "scale": "torus { 1, 0.3 scale <1, %s, %s> translate %s }",
    "rotate": "superellipsoid { <0.3, 0.3> rotate <%s, %s, %s> }",
    "clipped_by": "sphere { 0, 1 clipped_by { box { -%s, %s } } bounded_by { sphere { 0, %s } } }",
    "clipped deeply": "#local C = sphere { 0, %s } #for (I, 1, 40) #local C = sphere { 0, %s clipped_by { C } } #end"
    " object { C scale %s }",
}
# The same for what is around, on or in shapes.
WORLDS = {
    "camera": "camera { location <0, %s, -4> direction z*%s angle %s }",
    "camera vectors": "camera { location -4*z right x*%s up y*%s sky <0, %s, 0> look_at 0 }",
    "camera lens": "camera { location -4*z aperture %s blur_samples 4 focal_point %s*z variance %s }",
    "fisheye": "camera { fisheye location -4*z angle %s look_at <0, %s, 0> }",
    "light": "light_source { <%s, 4, -4>, %s fade_distance %s fade_power %s }",
    "spotlight": "light_source { <1, 4, -4>, 1 spotlight radius %s falloff %s tightness %s point_at <0, %s, 0> }",
    "area_light": "light_source { <1, 4, -4>, 1 area_light x*%s, y*%s, 3, 3 adaptive %s jitter }",
    "fog": "fog { fog_type 2 distance %s fog_offset %s fog_alt %s turbulence %s rgb 1 }",
    "rainbow": "rainbow { angle %s width %s distance %s color_map { [0 rgb 1] [1 rgb x] } direction z }",
    "sky_sphere": "sky_sphere { pigment { gradient y color_map { [%s rgb 1] [%s rgb x] } scale %s } }",
    "media": "media { emission %s scattering { 1, %s extinction %s } absorption %s intervals 2 }",
    "turbulence": "sphere { 0, 1 pigment { bozo turbulence %s octaves %s omega %s lambda %s } }",
    "pattern": "sphere { 0, 1 pigment { marble scale %s frequency %s phase %s ramp_wave } }",
    "waves": "sphere { 0, 1 pigment { gradient x poly_wave %s translate %s } normal { waves %s scale %s } }",
    "crackle": "sphere { 0, 1 pigment { crackle form <%s, 1, 0> metric %s offset %s scale %s } }",
    "facets": "sphere { 0, 1 pigment { rgb 1 } normal { facets coords %s scale %s } finish { phong %s } }",
    "agate": "sphere { 0, 1 pigment { agate agate_turb %s scale %s } normal { quilted %s control0 %s } }",
    "brick": "box { -1, 1 pigment { brick rgb 1, rgb x brick_size <%s, 1, 1> mortar %s scale %s } }",
    "mandel": "box { -1, 1 pigment { mandel 20 exponent 3 exterior 1, %s interior 2, %s scale %s } }",
    "julia": "box { -1, 1 pigment { julia <%s, %s>, 20 scale %s } }",
    "warps": "sphere { 0, 1 pigment { bozo warp { black_hole <%s, 0, 0>, %s falloff %s strength %s } } }",
    "repeat": "sphere { 0, 1 pigment { bozo warp { repeat x*%s offset <0, %s, 0> } warp { turbulence %s } } }",
    "mapping": "sphere { 0, 1 pigment { checker warp { toroidal major_radius %s orientation <0, %s, 1> } scale %s } }",
    "finish": "sphere { 0, 1 pigment { rgb 1 } finish { ambient %s diffuse %s specular %s roughness %s } }",
    "gloss": "sphere { 0, 1 pigment { rgb 1 } finish { phong %s phong_size %s brilliance %s crand %s metallic } }",
    "irid": "sphere { 0, 1 pigment { rgb 1 } finish { irid { %s thickness %s turbulence %s } } }",
    "mirror": "box { -1, 1 pigment { rgb 1 } finish { reflection { %s, 1 falloff %s exponent %s } } }",
    "mirrors": "#local T = texture { pigment { rgb %s } finish { reflection %s } } #for (I, 1, 5)"
    " #local T = texture { gradient y texture_map { [0 T] [0.5 pigment { rgb 1 } finish { reflection %s }] [1 T] } }"
    " #end union { box { -1, 1 } plane { y, -1 } texture { T } }",
    "glass": "sphere { 0, 1 pigment { rgbf %s } interior { ior %s fade_distance %s fade_power %s } }",
    "dispersion": "sphere { 0, 1 pigment { rgbf 1 } interior { ior 1.5 dispersion %s caustics %s } }",
    "subsurface": "global_settings { mm_per_unit %s subsurface { samples 4, 2 } }"
    " sphere { 0, 1 pigment { rgb 1 } finish { subsurface { translucency %s } diffuse %s } }",
    "radiosity": "global_settings { radiosity { count 4 error_bound %s minimum_reuse %s pretrace_end %s } }"
    " sphere { 0, 1 pigment { rgb 1 } }",
    "photons": "global_settings { photons { spacing 0.2 gather %s, %s radius %s } }"
    " sphere { 0, 1 pigment { rgbf 1 } interior { ior 1.5 } photons { target refraction on } }",
    "settings": "global_settings { adc_bailout %s ambient_light %s max_trace_level %s }"
    " sphere { 0, 1 pigment { rgb 1 } finish { reflection 1 } }",
}
INFINITE = "(1e308*10)"
VALUES = (INFINITE, f"({INFINITE} - {INFINITE})", "1e30", "1e-30", "0", "-1", "0.5", "1e7")
ORDINARY = "0.5"
PATIENCE = 5.0
NEWER = ("torus spindle", "lemon", "polynomial")
"""Shapes of version 3.8."""


class Endless(Exception):
    """A render takes too long."""


def rendered(scene: str) -> None:
    """Render, and see that it ends."""
    start = time.monotonic()

    def impatient(_: float) -> None:
        if time.monotonic() - start > PATIENCE:
            raise Endless(scene)

    try:
        picture = minipov.render(text=scene, width=4, height=3, on_message=lambda message: None, on_progress=impatient)
        assert picture.shape == (3, 4, 3)
    except SdlError as error:
        assert error.message
    assert time.monotonic() - start < PATIENCE, scene


def scenes(template: str, version: str = "3.7") -> list[str]:
    """A scene for each value at each place."""
    head = HEAD.replace("3.7", version)
    places = template.count("%s")
    given = [ORDINARY] * places
    return [
        head + template % (*given[:place], value, *given[place + 1 :]) for value in VALUES for place in range(places)
    ]


@pytest.mark.parametrize("name", SHAPES)
def test_extreme_shapes(name: str) -> None:
    for scene in scenes(SHAPES[name][:-1] + "pigment { rgb 1 } }", "3.8" if name in NEWER else "3.7"):
        rendered(scene)


@pytest.mark.parametrize("name", WORLDS)
def test_extreme_worlds(name: str) -> None:
    for scene in scenes(WORLDS[name] + " sphere { <1, 0, 0>, 0.5 pigment { rgb 1 } }"):
        rendered(scene)
