// Meshes with uv vectors and textures by corner, trailing commas, patterns of all kinds, an isosurface, media
#version 3.7;
#include "functions.inc"
global_settings { assumed_gamma 1 max_trace_level 5 hf_gray_16 off mm_per_unit 10 subsurface { samples 2, 2 } }
camera { location <0,0,-5> look_at <0,0,0> right -1.33*x up y angle 49.1 aperture 0.01 blur_samples 4 focal_point <0,0,0> }
background { rgbt <0.05, 0.05, 0.05, 0.75> }
sky_sphere { pigment { gradient y color_map { [0.0 rgbt <0.1,0.1,0.1,0.99>] [1.0 rgbt <0.2,0.2,0.3,0.99>] } scale 2 translate -1 } }
#declare MATERIAL_Glass = texture {
  pigment { rgbft <0.8, 0.9, 1.0, 0.7, 0.1> }
  finish { specular 0.5 roughness 1/800 ambient rgb 0 diffuse albedo 0.6 conserve_energy subsurface { translucency <0.5, 0.3, 0.2> } reflection { rgb 0, rgb 1 fresnel off falloff 2 exponent 1 metallic 0.5 } }
}
#declare DATA_mesh = mesh2 {
  vertex_vectors { 4, <-1.0000,-1.0000,0.0000>, <1.0000,-1.0000,0.0000>, <1.0000,1.0000,0.0000>, <-1.0000,1.0000,0.0000>, }
  normal_vectors { 1, <0.0, 0.0, -1.0>, }
  uv_vectors { 4, <0,0>, <1,0>, <1,1>, <0,1>, }
  texture_list { 2, texture { MATERIAL_Glass } texture { pigment { uv_mapping checker rgb 1, rgb 0 scale 0.1 } } }
  face_indices { 2, <0,1,2>,0,0,1, <0,2,3>,1,1,1, }
  normal_indices { 2, <0,0,0>, <0,0,0>, }
  uv_indices { 2, <0,1,2>, <0,2,3>, }
}
object { DATA_mesh interior { ior 1.5 caustics 0.5 fade_distance 1 fade_power 1001 fade_color <0.9,0.8,0.7> dispersion 1.02 } photons { target 1.0 refraction on reflection on collect off } matrix <1,0,0, 0,1,0, 0,0,1, 0,0,1.5> no_radiosity }
#declare Cloud = sphere { 0, 1 pigment { rgbt 1 } hollow interior { media { scattering { 5, rgb 0.3 eccentricity 0.2 extinction 1 } absorption 0.1 samples 4 method 3 density { spherical density_map { [0 rgb 0] [1 rgb 1] } } } } }
object { Cloud }
isosurface { function { f_sphere(x, y, z, 0.5) + f_noise3d(x*4, y*4, z*4)*0.1 } contained_by { sphere { 0, 1 } } threshold 0 accuracy 0.01 max_gradient 3 pigment { pavement number_of_sides 6 number_of_tiles 2 pattern 1 exterior 0 interior 1 form 1 } normal { bumps 0.3 scale 0.1 } translate y*2 }
#debug concat(vstr(3, max_extent(DATA_mesh), ",", 0, 1), "\n") // expect: 1.0,1.0,0.0
#debug concat(vstr(3, max_extent(Cloud), ",", 0, 1), "\n") // expect: 1.0,1.0,1.0
