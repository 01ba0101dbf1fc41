// Random grain on a surface
// class: close — crand is random
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.5, 1.5, -5> look_at <0.1, 0.2, 0> angle 45 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.2, 0.25, 0.3> }
sphere { <-0.8, 0.2, 0>, 0.8 pigment { rgb <0.8, 0.6, 0.4> } finish { crand 0.05 } }
sphere { <1.1, 0.2, 0>, 0.8 pigment { rgb <0.8, 0.6, 0.4> } }
