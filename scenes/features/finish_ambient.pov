// Ambient light by colour and by the global setting
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb <1, 0.9, 0.5> }
camera { location <0.5, 1.5, -5> look_at <0.1, 0.2, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 0.6 }
background { rgb <0.2, 0.25, 0.3> }
sphere { <-1.3, 0.2, 0>, 0.6 pigment { rgb <0.8, 0.3, 0.2> } finish { ambient 0 } }
sphere { <0, 0.2, 0>, 0.6 pigment { rgb <0.8, 0.3, 0.2> } finish { ambient 0.4 } }
sphere { <1.3, 0.2, 0>, 0.6 pigment { rgb <0.8, 0.3, 0.2> } finish { ambient rgb <0.2, 0.9, 0.4> } }
