// Radiosity: a bright sheet colours its surroundings
// class: close — radiosity is sampled
#version 3.7;
global_settings { assumed_gamma 1 radiosity { pretrace_start 0.08 pretrace_end 0.02 count 60 error_bound 0.6 recursion_limit 2 } }
camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 45 }
sky_sphere { pigment { rgb <0.6, 0.7, 0.9> } }
plane { y, 0 pigment { rgb 0.8 } }
box { <-1.5, 0, 0.6>, <1.5, 1.6, 0.7> pigment { rgb <0.9, 0.2, 0.1> } finish { emission 0.5 } }
sphere { <0, 0.6, -0.3>, 0.6 pigment { rgb 0.9 } }
