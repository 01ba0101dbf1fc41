"""The words that stand as items: a line each, as ``names | what it is``; synonyms share a line."""

from typing import Final

WORDS: Final = """
aa_level | most halvings of an interval in media method 3
aa_threshold | colour difference that makes media method 3 refine
absorption | colour that a media takes from light
accuracy | precision of a surface or of a normal's samples
adaptive | how coarsely an area light starts sampling
adc_bailout | rays that count for less than this are not traced
agate | banded stone pattern
agate_turb | turbulence of the agate pattern
albedo | the number that follows is a total reflected share
all | the filter or transmit that follows is for all colours of the picture
all_intersections | find every crossing of an isosurface
alpha | old name of filter
altitude | part of the slope pattern that depends on height
always_sample | let radiosity gather more during the final render
ambient | light that a surface has without any source
ambient_light | factor for all ambient values
angle | opening angle, in degrees
aoi | pattern of the angle between view and surface
aperture | size of the lens; larger blurs more
append | open a file for writing at its end
arc_angle | part of a rainbow's circle that shows
area_illumination | light areas by the whole area light, not only their shadows
area_light | a light with an extent: axes and grid size
array | an array: sizes in brackets, then values in braces
ascii | strings are ASCII
assumed_gamma | the space in which the scene's colours are given
autostop | share of the light's angle after which photons may stop
average | mix of all entries of a map, by weight
b_spline | B-spline curve
background | colour where no object is hit
bezier_spline | Bezier curves, four points each
bicubic_patch | surface from 16 control points
black_hole | warp that pulls points to a centre
blob | surface of fields that melt together
blue | blue component
blur_samples | rays per pixel for focal blur
bmp | BMP picture
bokeh | shape and colour of blurred highlights
bounded_by | simple object around this one, for speed
box | box between two corners
boxed | pattern that falls off from the origin as a cube
bozo | smooth noise pattern
brick | brick wall pattern
brick_size | size of a brick with its mortar
brightness | factor for radiosity's light
brilliance | how quickly diffuse light falls off with the angle
bump_map | bumps from a picture
bump_size | height of the bumps
bumps | noise pattern; as a normal, bumps
camera | the viewpoint
caustics | faked focussed light in shadows
cells | random value for each unit cube
charset | encoding of strings
checker | unit cubes of two kinds in turn
circular | arrange an area light in a circle
clipped_by | keep only the surface inside these objects
collect | whether photons are stored
color colour | a colour follows
color_map colour_map | colours by pattern value
component | old form of a blob's sphere
composite | old word for union
cone | cone or frustum
confidence | how sure sampling must be to stop
conic_sweep | prism that tapers to a point
conserve_energy | what is reflected is not transmitted
contained_by | box or sphere in which the surface is looked for
control0 | slope at the start of a quilted seam
control1 | slope at the end of a quilted seam
coords | size of facets by position
count | number of rays or photons
crackle | cell pattern
crand | random darkening
cube | third power, in a julia_fractal
cubic | polynomial of third order; pattern of a cube's six sides; warp
cubic_spline | Catmull-Rom curve
cubic_wave | wave that eases in and out
cutaway_textures | cut faces take the texture of the object that was cut
cylinder | cylinder; kind of camera or light
cylindrical | pattern that falls off from the y axis; warp
default | what is meant where nothing is said
density | how thick a media is
density_file | pattern from a df3 file
density_map | densities by pattern value
dents | normal pattern of dents
deprecated | warn when this name is used
df3 | voxel file
difference | first object without the others
diffuse | light scattered evenly
direction | where the camera looks; where a rainbow comes from
disc | flat disc, perhaps with a hole
dispersion | ratio of refraction for violet and red
dispersion_samples | colours into which dispersion splits light
dist_exp | how a warp depends on distance
distance | distance at which fog has covered most
double_illuminate | light both sides of the surface
eccentricity | direction preference of scattering
emission | light given off
error_bound | how freely radiosity samples are used again
evaluate | let an isosurface adapt its max_gradient
expand_thresholds | when to widen the search for photons
exponent | power
exr | OpenEXR picture
exterior | colouring outside a fractal; tile edges
extinction | share of scattering that dims what lies behind
face_indices | a mesh's triangles by vertex numbers
facets | normal pattern of flat pieces
fade_color fade_colour | colour that attenuation tends to
fade_distance | distance of half light
fade_power | how quickly light falls off
falloff | outer edge of a spotlight; shape of an effect
falloff_angle | angle over which a rainbow fades out
filter | share of light let through and coloured
finish | how a surface answers light
fisheye | camera with a circular picture
flatness | when a patch is flat enough
flip | mirror every other copy
focal_point | point that is sharp
fog | haze over distance
fog_alt | how fog thins with height
fog_offset | height below which fog is dense
fog_type | 1 even fog, 2 ground fog
form | weights of crackle's distances; shape of pavement
frequency | how often a pattern repeats
fresnel | reflect by Fresnel's law
function | a function of x, y, z or of named parameters
gamma | encoding of a picture's values
gather | photons collected at a point
gif | GIF picture
global_lights | let lights outside shine into the group
global_settings | settings for the whole scene
gradient | ramp along a vector
granite | fractal noise pattern
gray | grey value of a colour
gray_threshold | how grey radiosity's light is made
green | green component
hdr | Radiance picture
height_field | landscape from a picture
hexagon | hexagonal tiles of three kinds
hf_gray_16 | obsolete
hierarchy | use a search tree inside the object
hollow | the inside is not solid: media and fog may be in it
hypercomplex | algebra of a julia_fractal
iff | IFF picture
image_map | colours from a picture
image_pattern | pattern from a picture's grey values
importance | share of radiosity rays
inside_vector | direction in which a mesh's inside is looked for
interior | what fills an object; colouring inside a fractal
interior_texture | texture seen from inside
internal | built-in function by number
interpolate | smooth between pixels or voxels
intersection | what is inside all objects
intervals | pieces of a ray in media
inverse | turn inside and outside round
ior | index of refraction
irid | colours of thin films
irid_wavelength | wavelengths of red, green and blue for irid
isosurface | surface where a function has a value
jitter | random shifts against banding
jpeg | JPEG picture
julia | Julia set pattern
julia_fractal | cut through a four-dimensional Julia set
lambda | how much finer each octave is
lathe | curve turned about the y axis
leopard | spots in a lattice
light_group | lights that shine on the group's objects only
light_source | a light
linear_spline | straight pieces
linear_sweep | prism with parallel sides
load_file | read photons from a file
location | where the camera stands
look_at | point in the middle of the picture
looks_like | object shown where the light is
low_error_factor | error bound factor while pretracing
magnet | magnetic fractal pattern
major_radius | radius of a torus's circle
mandel | Mandelbrot set pattern
map_type | how a picture lies on a surface
marble | bands along x
material | texture and interior together
material_map | textures by a picture's palette
matrix | transformation by twelve numbers
max_gradient | steepest slope of the function
max_intersections | obsolete
max_iteration | most steps of a fractal
max_sample | brightest radiosity sample
max_trace | crossings of an isosurface that are found
max_trace_level | most reflections and refractions in a row
maximum_reuse | largest radius of a radiosity sample
media | what light meets inside a volume
media_attenuation | light is dimmed by media
media_interaction | light is scattered by media
merge | union without inner surfaces
mesh | triangles
mesh2 | triangles by shared vertices
mesh_camera | camera whose rays start on a mesh
metallic | highlights take the surface's colour
method | way of sampling
metric | kind of distance in crackle
minimum_reuse | smallest radius of a radiosity sample
mm_per_unit | millimetres in a unit, for subsurface
mortar | width of mortar
natural_spline | natural cubic curve
nearest_count | radiosity samples mixed
no_bump_scale | bumps do not grow with the object
no_image | not seen by the camera
no_radiosity | not seen by radiosity
no_reflection | not seen in mirrors
no_shadow | casts no shadow
noise_generator | which noise is used: 1, 2 or 3
normal | bumps painted on a surface
normal_indices | a mesh's normals by triangle
normal_map | normals by pattern value
normal_vectors | a mesh's normals
number_of_sides | sides of a pavement's tile
number_of_tiles | tiles put together in a pavement
number_of_waves | sources of ripples and waves
object | an object by name; pattern of inside and outside
octaves | layers of noise
offset | shift
omega | weight of each finer octave
omnimax | camera for domes
once | picture without repetition
onion | pattern of shells
open | without end caps
orient | turn an area light to the point it lights
orientation | direction in which a warp looks
orthographic | camera with parallel rays
ovus | egg
panoramic | wide camera
parallel | light with parallel rays
parametric | surface by three functions of u and v
pass_through | photons pass
pattern | pattern as a function; number of a pavement
pavement | pattern of polyform tiles
perspective | ordinary camera
pgm | PGM picture
phase | shift of a pattern's value
phong | size of a highlight's brightness
phong_size | sharpness of a phong highlight
photons | focussed light by photon mapping
pigment | colour of a surface
pigment_map | pigments by pattern value
pigment_pattern | pattern from a pigment's grey
planar | pattern that falls off from the xz plane; warp
plane | infinite plane
png | PNG picture
point_at | where a light points
poly | polynomial surface
poly_wave | wave by a power
polygon | flat polygon
polynomial | polynomial surface by its terms
pot | height field file
ppm | PPM picture
precision | how finely a fractal is followed
precompute | prepare a parametric surface
premultiplied | the picture's colours are multiplied by alpha
pretrace_end | finest pretrace step, as a share of the picture
pretrace_start | first pretrace step, as a share of the picture
prism | outline swept along y
projected_through | light shines only through this object
pwr | power, in a julia_fractal
quadratic_spline | curve through parabolas
quadric | surface of second order
quartic | surface of fourth order
quaternion | algebra of a julia_fractal
quick_color quick_colour | colour at low quality
quilted | pattern of cushions
radial | pattern round the y axis
radiosity | light from surface to surface
radius | radius; full-light edge of a spotlight
rainbow | rainbow
ramp_wave | saw-tooth wave
ratio | share of samples in lit parts
read | open a file for reading
reciprocal | 1/z, in a julia_fractal
recursion_limit | bounces of radiosity
red | red component
reflection | mirroring
reflection_exponent | power of reflected light
refraction | whether photons are refracted
repeat | copies along an axis
right | width and handedness of the picture
ripples | pattern of rings on water
rotate | turn about x, then y, then z, in degrees
roughness | width of a specular highlight
samples | samples taken
save_file | write photons to a file
scale | stretch
scallop_wave | wave of arches
scattering | light scattered by media
shadowless | light without shadows
sine_wave | sine wave
sint16be sint16le sint32be sint32le sint8 | signed number in a binary file
size | size of facets by direction
sky | upwards for the camera
sky_sphere | pigment all round the scene
slice | which three-dimensional cut is shown
slope | pattern of the surface's tilt
slope_map | bump profiles by pattern value
smooth | smooth shading
smooth_triangle | triangle with normals at its corners
solid | one value per crackle cell
sor | surface of revolution
spacing | distance between photons
specular | brightness of a specular highlight
sphere | ball
sphere_sweep | ball moving along a curve
spherical | pattern that falls off from the origin; camera; warp
spiral1 | spiral arms
spiral2 | spiral arms of another shape
spline | curve by parameter
split_union | treat a union's members singly for photons
spotlight | cone of light
spotted | smooth noise pattern
square | squares of four kinds
strength | strength of a field or warp
sturm | slower, safer root finding
subsurface | light below the surface
superellipsoid | rounded box
sys | system picture
target | photons are shot at this object
text | letters as solids
texture | pigment, normal and finish together
texture_list | textures of a mesh
texture_map | textures by pattern value
tga | Targa picture
thickness | thickness of a film
threshold | value at which a surface lies
tiff | TIFF picture
tightness | how quickly a spotlight falls off
tile2 | second texture of tiles
tiles | two textures as a checker
tiling | tiling of the plane by number
tolerance | precision of a sphere_sweep
toroidal | warp round a torus
torus | ring
transform | transformations put together
translate | shift
translucency | how far light goes below the surface
transmit | share of light let through unchanged
triangle | triangle
triangle_wave | wave up and down
triangular | triangles of six kinds
ttf | TrueType font file
turb_depth | how far along the ray fog's turbulence looks
turbulence | irregularity
type | kind
u_steps | divisions of a patch along u
uint16be uint16le uint8 | unsigned number in a binary file
ultra_wide_angle | camera for wide angles
union | objects together
up | height of the picture; upwards
use_alpha | use the picture's transparency
use_color use_colour | use the picture's colours
use_index | use the picture's palette numbers
utf8 | strings are UTF-8
uv_indices | a mesh's uv coordinates by triangle
uv_mapping | lay the texture by surface coordinates
uv_vectors | uv coordinates
v_steps | divisions of a patch along v
variance | difference at which sampling stops
vertex_vectors | a mesh's points
warp | bend the space of a pattern
water_level | cut off a height field below
waves | pattern of waves on water
width | width of a rainbow
wood | rings round the z axis
wrinkles | folded noise pattern
write | open a file for writing
xyz | powers of a polynomial's term
"""

WORDS_38: Final = """
anisotropy | direction preference of subsurface scattering
blend_gamma | space in which a map mixes colours
blend_mode | how a map mixes colours
bt2020 bt709 | encoding of a picture's values
cmap | which character table of a font is used
dictionary | values by name
dtag | debugging tag
global | the global names, as a dictionary
grey | grey value of a colour
grey_threshold | how grey radiosity's light is made
hf_grey_16 | obsolete
lemon | spindle between two discs
mixed | array of values of different types
optional | may be left out
polarity | which side of an isosurface is inside
potential | pattern of a blob's or isosurface's field
unofficial | for versions of other builds
user_defined | camera or pigment by functions
"""
