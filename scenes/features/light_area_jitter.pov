// An area light with jitter
// class: close — jittered samples are random
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-4, 5, -3>, rgb 1 area_light <1.5, 0, 0>, <0, 0, 1.5>, 6, 6 jitter adaptive 2 }
plane { y, 0 pigment { rgb <0.75, 0.72, 0.66> } }
sphere { <-0.6, 0.8, 0>, 0.6 pigment { rgb <0.8, 0.3, 0.2> } }
box { <0.5, 0, -0.6>, <1, 1.1, 0.2> pigment { rgb <0.2, 0.5, 0.8> } }
