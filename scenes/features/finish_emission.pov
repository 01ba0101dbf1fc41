// Emission, which ambient_light does not touch
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb 0 }
camera { location <0.5, 1.5, -5> look_at <0.1, 0.2, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 0.6 }
background { rgb <0.2, 0.25, 0.3> }
sphere { <-1.3, 0.2, 0>, 0.6 pigment { rgb <0.8, 0.3, 0.2> } finish { emission 0.2 } }
sphere { <0, 0.2, 0>, 0.6 pigment { rgb <0.8, 0.3, 0.2> } finish { emission rgb <0.9, 0.6, 0.1> diffuse 0.3 } }
sphere { <1.3, 0.2, 0>, 0.6 pigment { checker rgb <0.8, 0.3, 0.2> rgb <0.2, 0.5, 0.8> scale 0.3 } finish { emission 1 diffuse 0 } }
