// Prisms: linear with a hole, cubic, conic and bezier
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
prism { linear_spline 0, 0.6, 9, <0, 0>, <1, 0.1>, <0.8, 1>, <0.1, 0.9>, <0, 0>, <0.3, 0.3>, <0.7, 0.3>, <0.5, 0.7>, <0.3, 0.3> translate <-1.6, 0, -0.3> pigment { rgb <0.8, 0.3, 0.2> } }
prism { cubic_spline 0, 0.8, 7, <0, 1>, <0, 0>, <0.6, -0.3>, <0.8, 0.5>, <0.3, 0.7>, <0, 0>, <0.2, -0.5> translate <-0.2, 0, 0.5> pigment { rgb <0.9, 0.8, 0.2> } }
prism { conic_sweep linear_spline 0.3, 1, 5, <0.5, 0.5>, <-0.5, 0.4>, <-0.4, -0.5>, <0.5, -0.4>, <0.5, 0.5> rotate 180*x translate <0.9, 1, -0.2> pigment { rgb <0.2, 0.5, 0.8> } }
prism { bezier_spline 0, 0.3, 8, <0, 0>, <0.3, -0.5>, <0.7, 0.1>, <0.5, 0.5>, <0.5, 0.5>, <0.2, 0.8>, <-0.3, 0.4>, <0, 0> translate <0, 0, -1.5> pigment { rgb <0.3, 0.7, 0.3> } }
