// Lights that fade with distance, linear and quadratic
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.4, 2.8, -4.2> look_at <0.05, 0.35, 0> angle 50 }
light_source { <-1.4, 1.2, -0.4>, rgb <1, 0.7, 0.4> fade_distance 1 fade_power 2 }
light_source { <1.5, 0.8, 0.6>, rgb <0.4, 0.6, 1> fade_distance 0.6 fade_power 1 }
plane { y, 0 pigment { checker rgb 0.9 rgb 0.7 scale 0.5 } }
sphere { <0, 0.5, 0>, 0.5 pigment { rgb 0.9 } }
