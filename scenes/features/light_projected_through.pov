// Light projected through a window
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { rgb <0.75, 0.72, 0.66> } }
light_source { <1, 5, -4>, rgb <1, 0.8, 0.4> projected_through { disc { <0.5, 2.5, -2>, <0.5, 2.5, -2>, 0.5 } } }
sphere { <-0.2, 0.5, 0>, 0.5 pigment { rgb <0.8, 0.3, 0.2> } }
