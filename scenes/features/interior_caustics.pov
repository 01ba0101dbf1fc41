// Faked caustics under glass
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { rgb <0.75, 0.72, 0.66> } }
sphere { <-0.6, 0.9, 0>, 0.7 pigment { rgbf <0.9, 0.95, 1, 0.9> } interior { ior 1.4 caustics 0.8 } }
cylinder { <0.8, 0.2, -0.5>, <0.9, 1.1, 0.3>, 0.35 pigment { rgbf <1, 0.7, 0.6, 0.9> } interior { ior 1.3 caustics 0.3 } }
