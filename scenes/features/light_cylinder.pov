// A cylindrical light with soft rim and tightness
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.4, 2.8, -4.2> look_at <0.05, 0.35, 0> angle 45 }
light_source { <-3, 5, -3>, rgb 1.4 cylinder point_at <0.1, 0.2, 0> radius 0.7 falloff 1.3 tightness 2 }
light_source { <5, 5, -3>, rgb 0.15 }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.6, 0.7, 0.8> scale 0.5 } }
sphere { <-0.4, 0.6, 0>, 0.6 pigment { rgb <0.8, 0.3, 0.2> } }
box { <0.7, 0, -0.5>, <1.3, 0.8, 0.4> pigment { rgb <0.9, 0.8, 0.2> } }
