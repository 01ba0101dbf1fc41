// A sky vector that tilts the horizon
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 2.4, -5> sky <0.4, 1, 0.1> look_at <0, 0.7, 0> angle 45 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.3, 0.45, 0.35> } }
box { <-1, 0, -1>, <0.4, 1.5, 0.3> pigment { rgb <0.8, 0.3, 0.2> } }
cylinder { <1, 0, 0.5>, <1, 1.2, 0.5>, 0.4 pigment { rgb <0.2, 0.4, 0.8> } }
