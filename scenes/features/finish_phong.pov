// Phong highlights of several sizes
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.5, 1.5, -5> look_at <0.1, 0.2, 0> angle 45 }
light_source { <-5, 8, -7>, rgb <1, 0.9, 0.8> }
light_source { <6, 2, -5>, rgb <0.2, 0.3, 0.5> }
background { rgb <0.2, 0.25, 0.3> }
sphere { <-1.6, 0.2, 0>, 0.5 pigment { rgb <0.6, 0.2, 0.2> } finish { phong 0.5 } }
sphere { <-0.5, 0.2, 0>, 0.5 pigment { rgb <0.6, 0.2, 0.2> } finish { phong 1 phong_size 4 } }
sphere { <0.6, 0.2, 0>, 0.5 pigment { rgb <0.6, 0.2, 0.2> } finish { phong 1 phong_size 200 } }
sphere { <1.7, 0.2, 0>, 0.5 pigment { rgb <0.6, 0.2, 0.2> } finish { phong albedo 0.4 phong_size 15 } }
