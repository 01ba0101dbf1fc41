// Thin-film iridescence
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
sphere { <-0.8, 0.75, 0.2>, 0.75 pigment { rgb <0.2, 0.2, 0.3> } finish { irid { 0.6 thickness 0.5 turbulence 0.2 } diffuse 0.4 phong 0.4 } }
sphere { <0.9, 0.65, -0.2>, 0.65 pigment { rgb <0.3, 0.1, 0.1> } finish { irid { 0.4 thickness 0.8 } } }
