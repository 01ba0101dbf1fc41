// Scattering media in a spotlight beam
// class: close — media are sampled
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.4, 1.8, -4.2> look_at <0.05, 0.8, 0> angle 45 }
light_source { <-2, 3, 0>, rgb 2 spotlight point_at <0.5, 0, 0> radius 9 falloff 13 media_interaction on }
plane { y, 0 pigment { rgb 0.7 } }
box { <-2, 0.01, -1.5>, <2, 2.8, 1.5> pigment { rgbt 1 } hollow interior { media { scattering { 1, rgb 0.25 } samples 12 } } }
sphere { <0, 0.9, 0>, 0.25 pigment { rgb <0.8, 0.3, 0.2> } }
