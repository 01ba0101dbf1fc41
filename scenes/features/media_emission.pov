// Glowing media with a density
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { rgb <0.75, 0.72, 0.66> } }
sphere { 0, 1 pigment { rgbt 1 } hollow interior { media { emission rgb <1.5, 0.8, 0.3> density { spherical turbulence 0.3 color_map { [0 rgb 0] [0.4 rgb 0.3] [1 rgb 2] } } } } translate <0, 1, 0> }
