// A background colour seen directly, reflected and refracted
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 1.5, -4> look_at <0, 0.2, 0> angle 45 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.9, 0.5, 0.2> }
sphere { <-0.8, 0.2, 0>, 0.7 pigment { rgb 0.1 } finish { reflection 0.7 } }
sphere { <0.9, 0.2, 0>, 0.7 pigment { rgbf <0.5, 0.8, 1, 0.9> } interior { ior 1.4 } }
