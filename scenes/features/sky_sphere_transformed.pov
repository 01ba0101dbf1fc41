// A sky sphere scaled, moved and rotated
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at <0.3, 1.7, 0> angle 80 }
light_source { <-5, 8, -7>, rgb 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.4, 0.1>] [0.5 rgb <0.3, 0.2, 0.5>] [1 rgb <0.05, 0.05, 0.2>] } scale 2 translate -1 } rotate <15, 0, 30> }
sphere { <0.3, 0.8, 0>, 0.9 pigment { rgb <0.8, 0.7, 0.6> } }
