// A spotlight with tightness and a hard edge beside one that only tapers
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.5, 3.5, -4.5> look_at <0, 0.1, 0> angle 45 }
light_source { <-2, 4, -1>, rgb <1.5, 1.2, 0.8> spotlight point_at <-0.9, 0, 0> radius 20 falloff 20 tightness 30 }
light_source { <2, 4, -1>, rgb <0.8, 1, 1.5> spotlight point_at <0.9, 0, 0.3> radius 0 falloff 25 tightness 4 }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.6, 0.7, 0.8> scale 0.5 } }
cylinder { <-0.1, 0, 0.2>, <0, 0.8, 0.2>, 0.25 pigment { rgb <0.8, 0.3, 0.2> } }
