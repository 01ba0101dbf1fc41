// No camera at all: the default one looks along z from the origin
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
plane { y, -1 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.3, 0.45, 0.35> } }
box { <-2, -1, 4>, <-0.6, 0.5, 5.3> pigment { rgb <0.8, 0.3, 0.2> } }
sphere { <1, 0.2, 4>, 0.9 pigment { rgb <0.2, 0.4, 0.8> } }
