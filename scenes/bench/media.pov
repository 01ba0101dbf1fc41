// A spotlight in scattering air
// class: close — media are sampled at random
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at <0, 1, 0> angle 45 }
light_source { <4, 6, -3>, rgb 2 spotlight point_at <0, 0.5, 0> radius 8 falloff 14 }
light_source { <-5, 5, -6>, rgb 0.3 }
plane { y, 0 pigment { rgb 0.7 } }
sphere { <0, 0.7, 0>, 0.7 pigment { rgb <0.8, 0.3, 0.2> } }
box { <-5, 0, -4>, <5, 5, 5> pigment { rgbt 1 } hollow interior { media { scattering { 1, 0.05 extinction 0.5 } samples 20 method 3 intervals 1 } } }
