// A sky sphere brightened by emission
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at <0.3, 1.7, 0> angle 80 }
light_source { <-5, 8, -7>, rgb 1 }
sky_sphere { pigment { wrinkles color_map { [0 rgb <0.1, 0.2, 0.4>] [1 rgb <0.6, 0.5, 0.3>] } scale 0.5 } emission rgb <1.5, 1.2, 0.8> }
sphere { <0.3, 0.8, 0>, 0.9 pigment { rgb 0.1 } finish { reflection 0.7 } }
