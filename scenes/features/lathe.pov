// Lathes: linear, quadratic, cubic and bezier
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
lathe { linear_spline 5, <0, 0>, <0.4, 0.1>, <0.2, 0.6>, <0.5, 0.9>, <0.3, 1.2> translate <-1.2, 0, 0> pigment { rgb <0.8, 0.3, 0.2> } }
lathe { quadratic_spline 6, <0, -0.2>, <0.3, 0>, <0.4, 0.3>, <0.15, 0.6>, <0.4, 0.9>, <0.2, 1.1> pigment { rgb <0.9, 0.8, 0.2> } }
lathe { cubic_spline 6, <0, -0.2>, <0.3, 0>, <0.4, 0.3>, <0.15, 0.6>, <0.4, 0.9>, <0.2, 1.1> translate <1, 0, 0.2> pigment { rgb <0.2, 0.5, 0.8> } }
lathe { bezier_spline 4, <0, 0>, <0.6, 0.1>, <0.02, 0.4>, <0.4, 0.6> translate <0.4, 0, -1.2> pigment { rgb <0.3, 0.7, 0.3> } }
