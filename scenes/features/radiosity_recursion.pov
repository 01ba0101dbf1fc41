// Light thrown on twice in a closed box, gathered again where it is scarce
// class: close — gathering is random
#version 3.7;
global_settings {
  assumed_gamma 1
  radiosity { count 200 nearest_count 12 error_bound 0.4 recursion_limit 3 always_sample on pretrace_end 0.02 }
}
camera { location <0, 1, -2.9> look_at <0, 1, 0> angle 60 }
box { <-2, 0, -3>, <2, 2, 3> inverse pigment { rgb 0.9 } finish { diffuse 0.8 } }
box { <-1.2, 1.98, -1.2>, <1.2, 2, 1.2> pigment { rgb 1 } finish { emission 2 diffuse 0 } no_shadow }
box { <-1.99, 0, -1>, <-1.9, 2, 2> pigment { rgb <0.9, 0.2, 0.1> } finish { diffuse 0.8 } }
sphere { <0.5, 0.4, 0.2>, 0.4 pigment { rgb <0.3, 0.5, 0.9> } finish { diffuse 0.7 } }
