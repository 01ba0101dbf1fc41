// Before version 3.7 gathered light is added to ambient light
// class: close — gathering is random
#version 3.6;
global_settings { assumed_gamma 1 radiosity { count 200 error_bound 0.3 nearest_count 6 recursion_limit 1 pretrace_end 0.02 } }
background { rgb <0.5, 0.6, 0.9> * 0.5 }
camera { location <0, 2, -5> look_at <0, 0.8, 0> angle 50 }
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0.2 } }
box { <-2, 0, 0>, <-1, 2, 1> pigment { rgb <1, 0.2, 0.1> } finish { ambient 1 } }
sphere { <0, 0.8, 0.3>, 0.8 pigment { rgb 0.7 } finish { ambient 0.1 } }
