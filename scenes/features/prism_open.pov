// Open prisms show their inside
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.4, 2.6, -3.2> look_at <0.2, 0.3, 0.4> angle 45 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
prism { linear_spline 0, 0.7, 5, <-1, 0>, <0.1, -0.3>, <0.2, 0.8>, <-0.8, 1>, <-1, 0> open pigment { rgb <0.8, 0.3, 0.2> } }
prism { conic_sweep cubic_spline 0.3, 1, 7, <0.5, -0.6>, <0.5, 0.5>, <-0.5, 0.4>, <-0.4, -0.5>, <0.5, -0.4>, <0.5, 0.5>, <-0.5, 0.4> open translate <0.9, -0.3, 0.4> pigment { rgb <0.2, 0.5, 0.8> } }
