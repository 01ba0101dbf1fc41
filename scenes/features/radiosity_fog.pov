// Radiosity in fog and a global medium: gathering rays do not see them
// class: close — the rays of radiosity are random
#version 3.7;
global_settings {
  assumed_gamma 1
  radiosity { pretrace_start 0.08 pretrace_end 0.02 count 100 nearest_count 5 error_bound 0.4 recursion_limit 2 }
}
camera { location <0, 2, -7> look_at <0, 1, 0> }
sky_sphere { pigment { rgb <0.8, 0.85, 0.9> } }
plane { y, 0 pigment { rgb <0.4, 0.6, 0.3> } }
sphere { <-1, 1, 0>, 1 pigment { rgb <0.9, 0.5, 0.3> } }
box { <0.4, 0, -0.6>, <1.6, 1.6, 0.6> pigment { rgb <0.3, 0.4, 0.9> } rotate 20 * y }
fog { fog_type 2 fog_alt 0.5 fog_offset 0.5 distance 20 color rgb <1, 0.4, 0.2> }
media { absorption rgb <0.004, 0.002, 0> }
