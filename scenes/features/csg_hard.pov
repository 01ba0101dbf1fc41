// CSG where surfaces coincide or touch, with infinite parts, inverse and nested bounds
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -9> look_at <0, 0, 0> angle 50 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
#declare Red = texture { pigment { rgb <0.8, 0.3, 0.2> } }
#declare Blue = texture { pigment { rgb <0.2, 0.5, 0.8> } }
difference { box { -1, 1 texture { Red } } box { <0, 0, -1.001>, <1.001, 1.001, 1.001> texture { Blue } } scale 0.8 translate <-3, 1.5, 0> }
merge { box { <-1, -1, -1>, <0, 1, 1> } box { <0, -1, -1>, <1, 0.5, 1> } sphere { <0, 0.5, 0>, 0.8 } pigment { rgbt <0.8, 0.8, 0.2, 0.5> } interior_texture { pigment { rgb <0, 0.5, 0> } } scale 0.8 translate <-1, 1.5, 0> }
intersection { plane { y, 0.4 } plane { -y, 0.4 } quadric { <1, 0, 1>, <0, 0, 0>, <0, 0, 0>, -0.6 } plane { x, 0.2 inverse } texture { Red } translate <1, 1.5, 0> }
difference { intersection { sphere { 0, 1 } box { -0.8, 0.8 } } union { cylinder { -2*x, 2*x, 0.4 } cylinder { -2*y, 2*y, 0.4 } cylinder { -2*z, 2*z, 0.4 } } bounded_by { sphere { 0, 1.1 } } texture { Blue } rotate <20, 30, 0> translate <3, 1.5, 0> }
union { sphere { 0, 0.9 clipped_by { plane { z, 0.2 rotate 30*y } } } torus { 0.7, 0.25 clipped_by { box { -2, <2, 0.1, 2> } } } texture { Red } translate <-3, -1, 0> }
intersection { torus { 0.7, 0.3 } box { <-2, -1, -2>, <2, 0.1, 2> rotate 30*x } cutaway_textures texture { Blue } translate <-1, -1, 0> }
difference { cone { -0.8*y, 0.8, 0.8*y, 0.1 } superellipsoid { <0.4, 0.4> scale 0.5 translate -0.4*z } prism { linear_spline -1, 1, 4, <-0.2, -0.2>, <0.2, -0.2>, <0, 0.5>, <-0.2, -0.2> } texture { Red } translate <1, -1, 0> }
difference { blob { threshold 0.5 sphere { 0.3*x, 0.9, 1 } sphere { -0.3*x, 0.9, 1 } } lathe { linear_spline 4, <0, -0.9>, <0.3, -0.5>, <0.2, 0.9>, <0, 0.9> } plane { -z, 0.2 inverse translate -0.5*z } texture { Blue } translate <3, -1, 0> }
