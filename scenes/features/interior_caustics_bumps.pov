// Faked caustics of bumps and layers: a water surface, glass with two layers
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 3, -6> look_at <0, 0.5, 0> angle 55 }
light_source { <1, 30, -3>, rgb 0.6 }
background { rgb <0.3, 0.4, 0.5> }
plane { y, 0 pigment { rgb <0.8, 0.75, 0.65> } finish { diffuse 0.8 } }
difference {
  box { <-9, 3.9, -9>, <-0.5, 4, 9> }
  plane { z, -4 }
  pigment { rgbf <0.8, 0.9, 1, 0.95> }
  normal { bumps 0.4 scale 0.6 }
  interior { ior 1.2 caustics 1 }
}
box {
  <0.5, 1.2, -1.5>, <3, 1.3, 1.5>
  texture { pigment { rgbf <1, 0.9, 0.8, 0.9> } normal { ripples 0.5 scale 0.4 } }
  texture { pigment { rgbf 0.95 } normal { bumps 0.6 scale 0.3 } }
  interior { ior 1.2 caustics 0.7 }
}
