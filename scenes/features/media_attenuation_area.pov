// The atmosphere's media dim a soft light: the last part of the way is counted for all points at once
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 4, -9> look_at <0, 1, 0> angle 45 }
light_source { <-4, 9, -2>, rgb 3 media_attenuation on area_light <2, 0, 0>, <0, 0, 2>, 4, 4 }
light_source { <5, 7, -4>, rgb <0, 0.3, 0.6> media_attenuation on area_light <1, 0, 0>, <0, 0, 1>, 3, 3 adaptive 0 }
media { absorption rgb <0.02, 0.03, 0.05> }
plane { y, 0 hollow pigment { rgb 1 } }
box { <-2.5, 0.2, -0.5>, <-1, 1.6, 1> pigment { rgbf <1, 0.8, 0.7, 0.8> } hollow }
box { <0.6, 0.2, -0.5>, <2, 1.6, 1> pigment { rgbf <0.8, 1, 0.7, 0.8> } }
