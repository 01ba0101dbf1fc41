// A light that looks like an object
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 45 }
light_source { <-0.8, 1.5, -0.2>, rgb 1 looks_like { box { -0.2, <0.2, 0.3, 0.2> rotate 30*y pigment { rgb <1, 0.8, 0.3> } finish { emission 0.9 } } } }
plane { y, 0 pigment { rgb <0.75, 0.72, 0.66> } }
sphere { <0.6, 0.5, 0>, 0.5 pigment { rgb <0.2, 0.5, 0.8> } }
