// Dispersion spreads the colours
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
intersection { plane { <1, 0, -1>, 0.5 } plane { <-1, 0, -1>, 0.5 } plane { z, 0.3 } plane { y, 1.4 } plane { -y, -0.05 } rotate 40*y pigment { rgbf 0.98 } interior { ior 1.6 dispersion 1.15 dispersion_samples 9 } }
