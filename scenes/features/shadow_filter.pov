// Coloured shadows through filtering and transmitting glass
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { rgb <0.75, 0.72, 0.66> } }
light_source { <3, 6, 3>, rgb 0.6 }
box { <-1.3, 0, -0.1>, <-0.4, 1.3, 0> pigment { rgbf <0.9, 0.3, 0.2, 0.9> } }
box { <-0.3, 0, -0.2>, <0.5, 1.3, -0.1> pigment { rgbt <0.2, 0.9, 0.3, 0.7> } }
sphere { <1.1, 0.6, 0>, 0.5 pigment { rgbft <0.2, 0.4, 0.9, 0.5, 0.3> } }
