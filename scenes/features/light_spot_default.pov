// A spotlight with the default cone
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.4, 2.8, -4.2> look_at <0.05, 0.35, 0> angle 50 }
light_source { <-0.8, 2, -0.5>, rgb 1 spotlight point_at <0.3, 0, 0.2> }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.6, 0.7, 0.8> scale 0.5 } }
sphere { <0.3, 0.4, 0.2>, 0.4 pigment { rgb <0.8, 0.3, 0.2> } }
