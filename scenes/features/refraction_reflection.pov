// Glass that refracts and reflects
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
sphere { <-0.6, 0.8, 0>, 0.75 pigment { rgbf <0.95, 0.97, 1, 0.9> } finish { reflection { 0.05, 0.9 fresnel } conserve_energy specular 0.7 } interior { ior 1.6 } }
torus { 0.5, 0.2 pigment { rgbt <0.6, 0.9, 0.7, 0.8> } finish { reflection 0.2 } interior { ior 1.33 } rotate <60, 20, 0> translate <0.9, 0.6, -0.2> }
box { <-2, 0, 1.2>, <2, 0.8, 1.4> pigment { checker rgb <0.8, 0.3, 0.2> rgb <0.9, 0.8, 0.2> scale 0.4 } }
