// Gathered light: brightness, gray_threshold, max_sample, objects that are not gathered from
// class: close — gathering is random
#version 3.7;
global_settings {
  assumed_gamma 1
  radiosity { count 200 error_bound 0.3 nearest_count 6 recursion_limit 1 brightness 1.3 gray_threshold 0.4 max_sample 1.5 pretrace_end 0.02 }
}
background { rgb <0.5, 0.6, 0.9> }
camera { location <0, 2, -5> look_at <0, 0.8, 0> angle 50 }
plane { y, 0 pigment { rgb 0.8 } }
box { <-2, 0, 0>, <-1, 2, 1> pigment { rgb <1, 0.2, 0.1> } finish { emission 3 } }
box { <1, 0, 0>, <2, 2, 1> pigment { rgb <0.1, 0.9, 0.1> } finish { emission 3 } no_radiosity }
sphere { <0, 0.8, 0.3>, 0.8 pigment { rgb 0.7 } }
