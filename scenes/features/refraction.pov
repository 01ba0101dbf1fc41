// Glass: a sphere and a prism with different indices
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
sphere { <-0.7, 0.8, 0>, 0.7 pigment { rgbf <0.95, 0.97, 1, 0.95> } finish { phong 0.8 } interior { ior 1.5 } }
box { <0.4, 0.05, -0.6>, <1.2, 1.2, 0> pigment { rgbf <1, 0.9, 0.9, 0.9> } interior { ior 1.2 } rotate 15*y }
cylinder { <-2, 0.6, 1>, <2, 0.8, 1>, 0.2 pigment { rgb <0.8, 0.3, 0.2> } }
