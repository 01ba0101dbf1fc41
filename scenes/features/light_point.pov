// Three coloured point lights make coloured shadows
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 6, -4>, rgb <0.9, 0.2, 0.2> }
light_source { <4, 5, -6>, rgb <0.2, 0.8, 0.3> }
light_source { <0, 3, 3>, rgb <0.2, 0.3, 0.9> }
plane { y, 0 pigment { rgb 0.8 } }
sphere { <-0.6, 0.7, 0>, 0.6 pigment { rgb 0.9 } finish { phong 0.5 } }
box { <0.4, 0, -0.6>, <1, 1, 0.2> pigment { rgb 0.9 } }
