// Fog and media in one atmosphere: media change light first, and both dim a lamp
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 3, -9> look_at <0, 1, 0> angle 45 }
light_source { <-6, 9, -4>, rgb 4 media_attenuation on }
light_source { <6, 5, -4>, rgb 2 media_attenuation on media_interaction off }
fog { distance 20 rgb <0.5, 0.4, 0.2> }
media { absorption rgb <0.02, 0.04, 0.06> emission <0, 0, 0.01> }
plane { y, 0 hollow pigment { checker rgb 0.9 rgb 0.6 } }
sphere { <-1.6, 1.2, 0>, 1 pigment { rgbf 0.8 } hollow interior { media { absorption 0.3 emission <0.2, 0.05, 0> } } }
sphere { <1.4, 1.2, 0>, 1 pigment { rgbf <0.8, 1, 0.7, 0.8> } }
