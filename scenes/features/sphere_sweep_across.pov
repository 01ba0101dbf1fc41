// Sweeps looked at straight across, by parallel rays and parallel light
// class: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z right 4*x up 3*y look_at 0 }
light_source { <0, 0, -100>, 0.9 parallel point_at 0 }
light_source { <0, 100, 0>, 0.5 parallel point_at 0 }
sphere_sweep { linear_spline 3 <-1.5, -0.8, 0>, 0.3, <-0.7, 0.6, 0>, 0.3, <0, -0.6, 0>, 0.1 pigment { rgb <1, 0.6, 0.2> } }
sphere_sweep { linear_spline 3 <0.4, 0, 0>, 0.2, <1, 0.9, 0>, 0.4, <1.6, 0, 0>, 0.2 pigment { rgb <0.3, 0.7, 1> } rotate 180*y translate 2*x }
