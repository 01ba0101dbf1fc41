// Quick colours replace pigments at low quality
// class: exact
// switches: +Q4
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { rgb <0.75, 0.72, 0.66> } }
sphere { <-0.7, 0.7, 0>, 0.7 pigment { granite quick_color rgb <0.8, 0.3, 0.2> } finish { reflection 0.4 phong 0.5 } }
box { <0.3, 0, -0.5>, <1.2, 1.2, 0.4> pigment { checker rgb 1 rgb 0 scale 0.2 quick_colour rgb <0.2, 0.5, 0.8> } }
