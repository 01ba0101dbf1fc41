"""THE keyword table: every reserved word of SDL, what kind of word it is, since which version.

The lexer, the interpreter, the documentation and every editor grammar read this table.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Final


class Kind(Enum):
    """What a keyword is to the grammar."""

    CONSTANT = "constant"
    """A value without arguments: ``x``, ``pi``, ``clock``, ``on``."""
    UNARY_FUNCTION = "unary function"
    """A float function of one float, whose argument may hold comparisons: ``abs(1<2)``."""
    FUNCTION = "function"
    """Any other function, called with an argument list."""
    RGB = "rgb"
    """``rgb``, ``srgbft``...: what follows is an expression that may hold comparisons."""
    WORD = "word"
    """Anything else: an object, a block, a modifier, a pattern..."""


@dataclass(frozen=True, slots=True)
class Keyword:
    """One reserved word. In a scene whose ``#version`` is below ``since`` it is an ordinary identifier."""

    name: str
    kind: Kind
    since: float = 3.7


_CONSTANTS = """
x y z u v t pi true false yes no on off clock clock_on clock_delta frame_number initial_frame final_frame
initial_clock final_clock image_width image_height version input_file_name now
"""

_UNARY_FUNCTIONS = """
abs acos acosh asin asinh atan atanh ceil cos cosh degrees exp floor int ln log radians rand seed sin sinh sqrt
tan tanh
"""

_FUNCTIONS = """
asc atan2 bitwise_and bitwise_or bitwise_xor chr concat datetime defined dimension_size dimensions div file_exists
inside max max_extent min min_extent mod pow prod select str strcmp strlen strlwr strupr substr sum trace val
vaxis_rotate vcross vdot vlength vnormalize vrotate vstr vturbulence sqr
"""

_RGB = "rgb rgbf rgbt rgbft srgb srgbf srgbt srgbft"

_WORDS = """
aa_level aa_threshold absorption accuracy adaptive adc_bailout agate agate_turb albedo all all_intersections alpha
altitude always_sample ambient ambient_light angle aoi aperture append arc_angle area_illumination area_light array
ascii assumed_gamma autostop average b_spline background bezier_spline bicubic_patch black_hole blob blue
blur_samples bokeh bounded_by box boxed bozo brick brick_size brightness brilliance bump_map bump_size bumps camera
caustics cells charset checker circular clipped_by collect color color_map colour colour_map component composite cone
confidence conic_sweep conserve_energy contained_by control0 control1 coords count crackle crand cube cubic
cubic_spline cubic_wave cutaway_textures cylinder cylindrical default density density_file density_map dents
deprecated df3 difference diffuse direction disc dispersion dispersion_samples dist_exp distance double_illuminate
eccentricity emission error_bound evaluate expand_thresholds exponent exr exterior extinction face_indices facets
fade_color fade_colour fade_distance fade_power falloff falloff_angle filter finish fisheye flatness flip focal_point
fog fog_alt fog_offset fog_type form frequency fresnel function gamma gather gif global_lights global_settings
gradient granite gray gray_threshold green hdr height_field hexagon hf_gray_16 hierarchy hollow hypercomplex iff
image_map image_pattern importance inside_vector interior interior_texture internal interpolate intersection
intervals inverse ior irid irid_wavelength isosurface jitter jpeg julia julia_fractal lambda lathe leopard
light_group light_source linear_spline linear_sweep load_file location look_at looks_like low_error_factor magnet
major_radius mandel map_type marble material material_map matrix max_gradient max_intersections max_iteration
max_sample max_trace max_trace_level maximum_reuse media media_attenuation media_interaction merge mesh mesh2
mesh_camera metallic method metric minimum_reuse mm_per_unit mortar natural_spline nearest_count no_bump_scale
no_image no_radiosity no_reflection no_shadow noise_generator normal normal_indices normal_map normal_vectors
number_of_sides number_of_tiles number_of_waves object octaves offset omega omnimax once onion open orient
orientation orthographic ovus panoramic parallel parametric pass_through pattern pavement perspective pgm phase phong
phong_size photons pigment pigment_map pigment_pattern planar plane png point_at poly poly_wave polygon polynomial pot
ppm precision precompute premultiplied pretrace_end pretrace_start prism projected_through pwr quadratic_spline
quadric quartic quaternion quick_color quick_colour quilted radial radiosity radius rainbow ramp_wave ratio read
reciprocal recursion_limit red reflection reflection_exponent refraction repeat right ripples rotate roughness samples
save_file scale scallop_wave scattering shadowless sine_wave sint16be sint16le sint32be sint32le sint8 size sky
sky_sphere slice slope slope_map smooth smooth_triangle solid sor spacing specular sphere sphere_sweep spherical
spiral1 spiral2 spline split_union spotlight spotted square strength sturm subsurface superellipsoid sys target text
texture texture_list texture_map tga thickness threshold tiff tightness tile2 tiles tiling tolerance toroidal torus
transform translate translucency transmit triangle triangle_wave triangular ttf turb_depth turbulence type u_steps
uint16be uint16le uint8 ultra_wide_angle union up use_alpha use_color use_colour use_index utf8 uv_indices uv_mapping
uv_vectors v_steps variance vertex_vectors warp water_level waves width wood wrinkles write xyz
"""

_SINCE_38 = {
    Kind.CONSTANT: "tau",
    Kind.WORD: """
anisotropy blend_gamma blend_mode bmp bt2020 bt709 cmap dictionary dtag global grey grey_threshold hf_grey_16 lemon
mixed optional polarity potential unofficial user_defined
""",
}

_FAMILIES = (
    (Kind.CONSTANT, _CONSTANTS),
    (Kind.UNARY_FUNCTION, _UNARY_FUNCTIONS),
    (Kind.FUNCTION, _FUNCTIONS),
    (Kind.RGB, _RGB),
    (Kind.WORD, _WORDS),
)

KEYWORDS: Final[dict[str, Keyword]] = {
    word: Keyword(word, kind) for kind, words in _FAMILIES for word in words.split()
} | {word: Keyword(word, kind, 3.8) for kind, words in _SINCE_38.items() for word in words.split()}

_DIRECTIVES = """
break case debug declare default else elseif end error fclose fopen for if ifdef ifndef include local macro
max_intersections max_trace_level range read render statistics switch undef version warning while write
"""

DIRECTIVES: Final[frozenset[str]] = frozenset(_DIRECTIVES.split())
"""The words that may follow ``#``."""
