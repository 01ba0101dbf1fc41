// A shadowless light beside one that casts shadows
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 6, -4>, rgb <0.7, 0.4, 0.3> }
light_source { <6, 4, -5>, rgb <0.2, 0.4, 0.6> shadowless }
plane { y, 0 pigment { rgb <0.75, 0.72, 0.66> } }
sphere { <-0.6, 0.7, 0>, 0.6 pigment { rgb 0.9 } finish { phong 0.9 phong_size 20 } }
box { <0.5, 0, -0.6>, <1.1, 1.1, 0.2> pigment { rgb 0.9 } }
