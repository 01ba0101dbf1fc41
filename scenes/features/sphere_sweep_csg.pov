// A b_spline sweep in a difference, squeezed
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.5, 2.3, -6> look_at <1.5, 0.7, 0> angle 50 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
sphere_sweep { linear_spline 4, <-1.6, 0.2, 0>, 0.1, <-1, 1.2, 0.3>, 0.3, <-0.6, 0.5, -0.4>, 0.15, <-0.2, 0.9, 0>, 0.05 pigment { rgb <0.8, 0.3, 0.2> } }
sphere_sweep { cubic_spline 6, <0, 0, 1>, 0.1, <0, 0.2, 0.6>, 0.15, <0.4, 0.9, 0.2>, 0.25, <1, 0.4, 0>, 0.15, <1.3, 1.2, -0.3>, 0.1, <1.5, 1.5, 0>, 0.1 pigment { rgb <0.2, 0.5, 0.8> } }
difference { sphere_sweep { b_spline 7, <-0.8, 0.2, -1>, 0.1, <0, 0.4, -1.3>, 0.2, <0.5, 0.1, -0.8>, 0.4, <1, 0.6, -1.1>, 0.1, <1.4, 0.2, -1>, 0.1 <2,2,0>,.5, <1,2,0>,.5 tolerance 0.01 }  plane{z,-0.9} pigment { rgb <0.9, 0.8, 0.2> } interior_texture{pigment{rgb x}} translate x*2 scale <1,1.2,1> }
