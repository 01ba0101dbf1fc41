// Fog dims light on its way from a lamp: over two kinds of fog, through hollow and solid glass, and not if the lamp is left alone
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 3, -9> look_at <0, 1, 0> angle 45 }
light_source { <-6, 9, -4>, rgb <6, 4, 2> media_attenuation on }
light_source { <6, 9, -4>, rgb <0.1, 0.2, 0.4> }
fog { distance 9 rgbft <0.5, 0.5, 0.6, 0.3, 0.02> }
fog { distance 6 rgb 0.4 fog_type 2 fog_offset 0.5 fog_alt 1 }
plane { y, 0 hollow pigment { checker rgb 0.9 rgb 0.6 } }
sphere { <-1.6, 1.2, 0>, 1 pigment { rgbf <1, 0.8, 0.7, 0.8> } hollow }
sphere { <1.4, 1.2, 0>, 1 pigment { rgbf <0.8, 1, 0.7, 0.8> } }
box { <-0.3, 0, 1.5>, <0.3, 2.2, 2> pigment { rgb <0.8, 0.3, 0.2> } }
