// Iridescence of layers that are mirrors: each mirror's image is coloured by the film of its own layer
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 irid_wavelength rgb <0.6, 0.5, 0.4> }
camera { location <0, 1.5, -5> look_at 0 angle 40 }
light_source { <4, 5, -3>, rgb 0.9 }
background { rgb <0.4, 0.5, 0.6> }
plane { y, -1 pigment { checker rgb 0.9 rgb 0.2 } }
#declare Below = texture { pigment { rgb <0.9, 0.4, 0.2> } finish { reflection 0.4 irid { 0.5 thickness 0.4 } } }
#declare Above = texture { pigment { rgbft <0.5, 0.9, 0.3, 0.5, 0.3> } finish { irid { 0.3 thickness 0.7 turbulence 0.5 } specular 0.5 } }
sphere { <-1.1, 0, 0>, 1 texture { Below } texture { Above } }
sphere { <1.1, 0, 0>, 1 texture { pigment { rgb <0.4, 0.4, 0.9> } finish { reflection 0.4 } } texture { Above finish { reflection { 0.1, 0.6 } conserve_energy } } }
