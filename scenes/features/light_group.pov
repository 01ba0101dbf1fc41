// A light group lights only its own
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 0.7 }
plane { y, 0 pigment { rgb 0.7 } }
light_group { light_source { <3, 4, -3>, rgb <1, 0.7, 0.2> } sphere { <-0.7, 0.6, 0>, 0.6 pigment { rgb 0.9 } } box { <-0.2, 0, -1.3>, <0.2, 0.4, -1> pigment { rgb 0.9 } } }
light_group { light_source { <3, 4, -3>, rgb <0.3, 0.5, 1> } box { <0.5, 0, -0.3>, <1.3, 1, 0.5> pigment { rgb 0.9 } } global_lights on }
