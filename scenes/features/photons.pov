// Photons focused by a glass ball
// class: close — photons are sampled
#version 3.7;
global_settings { assumed_gamma 1 photons { count 20000 } }
camera { location <1, 3.5, -3.5> look_at <0.3, 0.1, 0> angle 45 }
light_source { <-4, 4, -1>, rgb 1 }
plane { y, 0 pigment { rgb 0.7 } }
sphere { <-0.2, 0.7, 0>, 0.6 pigment { rgbf <0.9, 0.95, 1, 0.95> } interior { ior 1.5 } photons { target reflection off refraction on } }
