"""The features of the language, in the words of docs/features.md, each with the scenes that show it.

A feature's scenes are globs below scenes/features; a folder of tests/language or a file of tests/cli stands for
features that no picture shows. `features_page` turns the table into the page.
"""

from __future__ import annotations

from typing import TypeAlias

Row: TypeAlias = tuple[str, str]
"""What it is, and what shows it (globs or test folders, separated by blanks; nothing: no test yet)."""

PATTERNS = (
    "agate", "aoi", "boxed", "bozo", "brick", "bumps", "cells", "checker", "crackle", "cubic", "cylindrical",
    "density_file", "dents", "function", "gradient", "granite", "hexagon", "image", "julia", "leopard", "magnet",
    "mandel", "marble", "object", "onion", "pavement", "pigment", "planar", "quilted", "radial", "ripples", "slope",
    "spherical", "spiral1", "spiral2", "spotted", "square", "tiling", "triangular", "waves", "wood", "wrinkles",
)  # fmt: skip

_PART = {"tiling": " 1 to 24"}
"""Patterns of which only a part is rendered."""

FEATURES: dict[str, list[Row]] = {
    "Language": [
        ("nested comments, comments inside statements", "tests/language/comments"),
        ("numbers, constants (`pi`, in 3.8 `tau`), `clock`, `image_width`, `frame_number`, `now`",
         "tests/language/constants tests/language/additions"),
        ("operators: precedence, relations, logic, choice, promotion of numbers", "tests/language/expressions"),
        ("vectors of 2 to 5 terms, components, arithmetic", "tests/language/vectors"),
        ("colours: `rgb`, `rgbf`, `rgbt`, `rgbft`, `srgb…`, words, arithmetic, components", "tests/language/colours"),
        ("strings, `concat`, `str`, `substr`, `vstr`, `chr`, `strcmp`, escapes", "tests/language/strings"),
        ("functions of numbers and vectors, `min_extent`, `vrotate`, `vturbulence`",
         "tests/language/functions tests/language/vectors tests/language/objects"),
        ("`function { … }`: own functions, `pattern`, `pigment`, `transform`, `spline`, `internal`, `sum`, `prod`",
         "tests/language/functions pattern_function* isosurface*"),
        ("`rand`, `seed`: the same numbers", "tests/language/random"),
        ("`#declare`, `#local`, `#undef`, scopes, `deprecated`", "tests/language/scope tests/language/directives"),
        ("`#if`, `#ifdef`, `#switch`, `#while`, `#for`, `#break`, also in the middle of statements",
         "tests/language/control"),
        ("`#macro`: parameters by reference, textual expansion, recursion", "tests/language/macros"),
        ("arrays of 1 to 5 dimensions, initialisers", "tests/language/arrays"),
        ("splines of all types", "tests/language/splines"),
        ("`#include`, search through folders, extensions", "tests/language/includes"),
        ("`#fopen`, `#read`, `#write`, binary words", "tests/language/files"),
        ("`#debug`, `#warning`, `#error`, `#render`, `#statistics`",
         "tests/language/streams tests/errors"),
        ("`#version` and what it changes, `#default`",
         "tests/language/version tests/language/default version_* texture_default*"),
        ("objects as values, `trace`, `inside`, `min_extent`, `max_extent`", "tests/language/objects"),
        ("additions of 3.8: dictionaries, tuples, optional parameters, growing and mixed arrays",
         "tests/language/additions"),
    ],
    "Finite solids": [
        ("`sphere`", "sphere"),
        ("`box`", "box"),
        ("`cone`, `cylinder`, `open`", "cone* cylinder cylinder_open"),
        ("`torus`, `sturm`", "torus torus_sturm"),
        ("spindle modes of `torus` (3.8)", "tests/tracer/test_additions.py"),
        ("`blob`: spheres, cylinders, negative strengths, component textures", "blob*"),
        ("`lathe`: four kinds of splines", "lathe*"),
        ("`prism`: splines, holes, conic sweep, `open`", "prism*"),
        ("`sor`", "sor*"),
        ("`superellipsoid`", "superellipsoid*"),
        ("`sphere_sweep`: three kinds of splines", "sphere_sweep*"),
        ("`height_field`: smooth, `water_level`, 16 bits, POT files", "height_field*"),
        ("`isosurface`: containers, `max_gradient`, `evaluate`, `all_intersections`", "isosurface*"),
        ("`julia_fractal`: `quaternion` and `hypercomplex`, function `sqr`", "julia_fractal"),
        ("`julia_fractal`: hypercomplex functions as `exp` and `pwr`", "julia_fractal_function*"),
        ("`parametric`", "parametric*"),
        ("`text` from TrueType fonts", "text text_[!u]*"),
        ("`ovus`", "ovus*"),
        ("`lemon` (3.8)", "tests/tracer/test_additions.py"),
    ],
    "Patches and meshes": [
        ("`triangle`, `smooth_triangle`", "triangle smooth_triangle"),
        ("`disc` with a hole", "disc"),
        ("`polygon` with holes", "polygon"),
        ("`bicubic_patch` of types 0 and 1", "bicubic_patch*"),
        ("`mesh`: textures of triangles and corners, `uv_vectors`, `inside_vector`", "mesh mesh_*"),
        ("`mesh2`: normals, uv, texture lists, index lists", "mesh2*"),
    ],
    "Infinite solids": [
        ("`plane`", "plane"),
        ("`quadric`", "quadric*"),
        ("`cubic`, `quartic`, `poly`, `polynomial`", "quartic* poly poly_*"),
    ],
    "CSG and modifiers": [
        ("`union`, `merge`, `intersection`, `difference`, nested", "csg_*"),
        ("`inverse`", "csg_inverse"),
        ("`split_union`", "csg_split_union*"),
        ("surfaces in one place: which is seen", "coincident_faces"),
        ("`cutaway_textures`", "cutaway_textures"),
        ("`clipped_by`, `bounded_by`", "clipped_by bounded_by"),
        ("`no_shadow`, `no_image`, `no_reflection`, `double_illuminate`",
         "no_shadow no_image_no_reflection double_illuminate"),
        ("`hollow`", "fog_hollow refraction_nested"),
        ("`interior_texture`", "interior_texture"),
        ("`translate`, `rotate`, `scale`, `matrix`, declared transforms, `inverse`", "transform_*"),
    ],
    "Pigments and textures": [
        ("colours with filter and transmit", "filter_transmit"),
        ("`color_map`: edges, old syntax, declared maps", "map_*"),
        ("`pigment_map`, lists of pigments, `average`", "pigment_map pigment_checker pigment_average"),
        ("`texture_map`, lists of textures, `average`", "texture_map texture_checker texture_average"),
        ("layered textures", "texture_layered*"),
        ("`material_map`", "material_map*"),
        ("`tiles`", "texture_tiles*"),
        ("`quick_color` and qualities", "quick_color quality_*"),
        ("`user_defined` (3.8)", "tests/tracer/test_additions.py"),
    ],
    "Patterns": [(f"`{name}`{_PART.get(name, '')}", f"pattern_{name} pattern_{name}_*") for name in PATTERNS]
    + [
        ("`tiling` 25 to 27", "pattern_tiling_aperiodic*"),
        ("`crackle` with `repeat` (3.8)", "tests/tracer/test_additions.py"),
    ],
    "Pattern modifiers": [
        ("waves: `ramp_wave`, `sine_wave`, `triangle_wave`, `scallop_wave`, `cubic_wave`, `poly_wave`",
         "wave_*_wave wave_blocks pattern_value_range"),
        ("`frequency`, `phase`", "wave_frequency_*"),
        ("`turbulence`, `octaves`, `omega`, `lambda`", "turbulence_*"),
        ("`noise_generator` 1, 2, 3", "noise_generator_*"),
        ("`warp`: repeat, black hole, turbulence, mappings", "warp_*"),
        ("`uv_mapping`", "uv_* image_map_uv"),
    ],
    "Images": [
        ("`image_map`: PNG, GIF, TGA, PPM, JPEG, BMP, TIFF", "image_map image_map_formats"),
        ("map types: planar, spherical, cylindrical, toroidal; `once`",
         "image_map_spherical image_map_cylindrical* image_map_torus image_map_once"),
        ("`interpolate`", "image_map_interpolate_*"),
        ("alpha, `filter`, `transmit`, palettes", "image_map_alpha image_map_filter image_map_palette"),
        ("`gamma` of image files", "image_map_gamma"),
        ("functions as images", "image_map_function*"),
        ("`bump_map`", "bump_map*"),
    ],
    "Normals": [
        ("`bumps`, `dents`, `ripples`, `waves`, `wrinkles`", "normal_bumps* normal_dents normal_ripples* normal_waves* "
         "normal_wrinkles"),
        ("`quilted`, `facets`", "normal_quilted normal_facets*"),
        ("any pattern as a normal", "normal_signed_amount "
         "normal_agate normal_bozo normal_brick normal_cells normal_checker normal_crackle "
         "normal_gradient* normal_granite normal_hexagon normal_leopard normal_marble normal_onion normal_radial "
         "normal_spiral* normal_spotted normal_wood"),
        ("`normal_map`, lists, `average`", "normal_normal_map* normal_average* normal_list_* normal_map_*"),
        ("`slope_map`", "normal_slope_map*"),
        ("`bump_size`, `accuracy`, `no_bump_scale`", "normal_bump_size normal_accuracy normal_no_bump_scale*"),
        ("functions as normals", "normal_function*"),
        ("warps and uv mapping of normals", "normal_warps normal_uv*"),
    ],
    "Finishes": [
        ("`ambient`, `emission`, `diffuse`, `brilliance`", "finish_ambient finish_emission finish_diffuse "
         "finish_brilliance finish_terms"),
        ("`phong`, `specular`, `roughness`, `metallic`", "finish_phong finish_specular finish_metallic"),
        ("`crand`", "finish_crand"),
        ("`irid`", "finish_irid*"),
        ("`reflection`: variable, `fresnel`, `falloff`, `exponent`, `metallic`", "reflection_*"),
        ("`conserve_energy`", "reflection_conserve_energy"),
        ("`subsurface`", "finish_subsurface*"),
    ],
    "Cameras": [
        ("`perspective`, `angle`, `right`, `up`, `direction`, `sky`, `look_at`, transforms",
         "camera_default camera_perspective camera_right_handed camera_sky camera_transforms camera_vectors"),
        ("`orthographic`", "camera_orthographic*"),
        ("`fisheye`", "camera_fisheye*"),
        ("`ultra_wide_angle`", "camera_ultra_wide_angle*"),
        ("`omnimax`", "camera_omnimax"),
        ("`panoramic`", "camera_panoramic*"),
        ("`cylinder` 1 to 4", "camera_cylinder_*"),
        ("`spherical`", "camera_spherical*"),
        ("`mesh_camera`", "camera_mesh*"),
        ("`user_defined` (3.8)", "tests/tracer/test_cameras.py"),
        ("focal blur, `bokeh`", "camera_focal_blur* camera_bokeh"),
        ("`normal` of a camera", "camera_normal*"),
        ("`normal` of an `omnimax` camera", "camera_omnimax_normal*"),
    ],
    "Lights": [
        ("point lights, `fade_distance`, `fade_power`", "light_point light_fade*"),
        ("`spotlight`, `tightness`", "light_spot*"),
        ("`cylinder`", "light_cylinder*"),
        ("`parallel`", "light_parallel*"),
        ("`shadowless`", "light_shadowless"),
        ("`area_light`: `adaptive`, `circular`, `orient`, `area_illumination`", "light_area light_area_[!j]*"),
        ("`jitter` of area lights", "light_area_jitter*"),
        ("`looks_like`", "light_looks_like*"),
        ("`projected_through`", "light_projected_through*"),
        ("`light_group`", "light_group*"),
        ("shadows through coloured glass", "shadow_filter"),
    ],
    "Atmosphere": [
        ("`background`", "background"),
        ("`fog` of types 1 and 2, turbulence, several fogs", "fog_*"),
        ("`sky_sphere`", "sky_sphere*"),
        ("`rainbow`: arcs, fading ends, several, with fog and media", "rainbow*"),
    ],
    "Interiors and media": [
        ("`ior`, total internal reflection, nested media", "refraction* interior_overlapping interior_camera"),
        ("`fade_distance`, `fade_power`, `fade_color`", "interior_fade*"),
        ("`caustics`", "interior_caustics*"),
        ("`refraction`, `caustics` in a finish", "finish_old_refraction"),
        ("`dispersion`", "interior_dispersion*"),
        ("`media`: absorption, emission", "media_absorption* media_emission*"),
        ("`media`: `scattering` of types 1 to 5", "media_scattering* media_objects"),
        ("`media`: `method` 1", "media_monte_carlo*"),
        ("`media`: methods, densities, atmospheric media",
         "media_method* media_density* media_atmosphere* media_beams media_intervals media_several"),
        ("`media_attenuation`", "media_attenuation* fog_lamp"),
    ],
    "Global illumination": [
        ("`radiosity`", "radiosity*"),
        ("`photons`: refraction, reflection, highlights", "photons photons_[!m]* photons_mirror"),
        ("`photons` in media", "photons_media*"),
    ],
    "Global settings": [
        ("`assumed_gamma`", "gamma_*"),
        ("`adc_bailout`, `max_trace_level`", "adc_bailout* max_trace_level*"),
    ],
    "Command line": [
        ("POV-Ray's switches, INI files, `povray.ini`, `POVINC`, `POVINI`", "tests/cli/test_options.py"),
        ("file types, bits, alpha, parts of a picture, animations", "tests/cli/test_program.py"),
        ("antialiasing methods 1 and 2, `Antialias_Gamma`, jitter", "antialias_*"),
        ("message streams and their files, the wording that programs look for", "tests/cli/test_program.py"),
        ("dithering", "tests/cli/test_dither.py"),
    ],
}  # fmt: skip
