// A parallel spotlight
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.4, 2.8, -4.2> look_at <0.05, 0.35, 0> angle 45 }
light_source { <-2, 3, -1.5>, rgb 1.3 spotlight parallel point_at <0.1, 0, 0> radius 15 falloff 25 }
light_source { <5, 5, -3>, rgb 0.15 }
plane { y, 0 pigment { rgb <0.8, 0.75, 0.65> } }
#for (I, -3, 3) cylinder { <I*0.5, 0, 0.3*I>, <I*0.5, 0.6, 0.3*I>, 0.08 pigment { rgb <0.8, 0.3, 0.2> } } #end
