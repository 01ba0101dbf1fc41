// Sphere sweeps: linear, cubic and b-spline
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.4, 2.3, -4.2> look_at <0.05, 0.55, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
light_source { <9, 4, -3>, rgb <0.3, 0.22, 0.15> }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.75, 0.65> rgb <0.4, 0.5, 0.55> scale 0.7 } }
sphere_sweep { linear_spline 4, <-1.6, 0.2, 0>, 0.1, <-1, 1.2, 0.3>, 0.3, <-0.6, 0.5, -0.4>, 0.15, <-0.2, 0.9, 0>, 0.05 pigment { rgb <0.8, 0.3, 0.2> } }
sphere_sweep { cubic_spline 6, <0, 0, 1>, 0.1, <0, 0.2, 0.6>, 0.15, <0.4, 0.9, 0.2>, 0.25, <1, 0.4, 0>, 0.15, <1.3, 1.2, -0.3>, 0.1, <1.5, 1.5, 0>, 0.1 pigment { rgb <0.2, 0.5, 0.8> } }
sphere_sweep { b_spline 5, <-0.8, 0.2, -1>, 0.1, <0, 0.4, -1.3>, 0.2, <0.5, 0.1, -0.8>, 0.2, <1, 0.6, -1.1>, 0.1, <1.4, 0.2, -1>, 0.1 tolerance 0.01 pigment { rgb <0.9, 0.8, 0.2> } }
