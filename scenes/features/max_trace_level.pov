// Two mirrors and few levels of recursion
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 3 }
camera { location <0.5, 1.6, -2.5> look_at <0, 0.6, 1> angle 60 }
light_source { <0.5, 3, -1>, rgb 1 }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.3, 0.45, 0.35> scale 0.5 } }
plane { <0.3, 0, -1>, -1.5 pigment { rgb 0.1 } finish { reflection 0.9 } }
plane { <0.1, 0, 1>, -3 pigment { rgb 0.1 } finish { reflection 0.9 } }
sphere { <-0.3, 0.4, 0.4>, 0.4 pigment { rgb <0.8, 0.3, 0.2> } }
