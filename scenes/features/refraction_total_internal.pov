// Total internal reflection inside a prism and a rod
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
intersection {
  plane { <1, 0, -1>, 0.5 } plane { <-1, 0, -1>, 0.5 } plane { z, 0.3 } plane { y, 1.2 } plane { -y, -0.1 }
  rotate 60*y translate <-0.4, 0, 0.2>
  pigment { rgbf 0.95 } finish { phong 0.6 } interior { ior 1.7 }
}
cylinder { <0.5, 0.3, -0.8>, <1.4, 0.6, 0.4>, 0.28 pigment { rgbf <0.9, 1, 0.9, 0.9> } interior { ior 1.5 } }
sphere { <0.2, 0.4, 1.2>, 0.4 pigment { rgb <0.8, 0.3, 0.2> } }
