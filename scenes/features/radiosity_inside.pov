// Radiosity of surfaces inside a transparent body: gathering rays start as if in open space
// class: close — the rays of radiosity are random
#version 3.7;
global_settings {
  assumed_gamma 1
  radiosity { pretrace_start 0.08 pretrace_end 0.02 count 100 nearest_count 5 error_bound 0.4 recursion_limit 1 media on }
}
camera { location <0, 2, -7> look_at <0, 1, 0> }
sphere { 0, 100 hollow pigment { rgb 0.7 } finish { emission 1 diffuse 0 } }
sphere {
  0, 30
  hollow
  pigment { rgbt 1 }
  finish { diffuse 0 }
  interior { ior 1.2 fade_power 1 fade_distance 10 fade_color <1, 0.5, 0> media { absorption rgb <0.01, 0.005, 0> } }
}
plane { y, 0 pigment { rgb <0.4, 0.6, 0.3> } }
sphere { <-1, 1, 0>, 1 pigment { rgb <0.9, 0.5, 0.3> } }
