// Brilliance tightens and widens the diffuse light
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.5, 1.5, -5> look_at <0.1, 0.2, 0> angle 45 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.2, 0.25, 0.3> }
sphere { <-1.6, 0.2, 0>, 0.5 pigment { rgb <0.8, 0.6, 0.2> } finish { brilliance 0.4 } }
sphere { <-0.5, 0.2, 0>, 0.5 pigment { rgb <0.8, 0.6, 0.2> } finish { brilliance 1 } }
sphere { <0.6, 0.2, 0>, 0.5 pigment { rgb <0.8, 0.6, 0.2> } finish { brilliance 3 } }
sphere { <1.7, 0.2, 0>, 0.5 pigment { rgb <0.8, 0.6, 0.2> } finish { brilliance 9 diffuse 1 } }
