// Built-in functions at a few points
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"
#macro Say(V) #debug concat(str(V, 0, 5), "\n") #end
Say(f_sphere(1, 2, 3, 1))
Say(f_torus(1, 0.2, 0.3, 1, 0.25))
Say(f_rounded_box(0.5, 0.4, 0.3, 0.1, 1, 1, 1))
Say(f_helix1(0.3, 0.2, 0.1, 2, 3, 0.1, 0.8, 1, 0.3, 45))
Say(f_superellipsoid(0.5, 0.4, 0.3, 0.8, 0.9))
Say(f_noise3d(1.1, 2.2, 3.3))
Say(f_noise_generator(1.1, 2.2, 3.3, 1))
Say(f_ridged_mf(1.1, 2.2, 3.3, 0.5, 2, 4, 0.6, 2, 2))
Say(f_hetero_mf(1.1, 2.2, 3.3, 0.9, 2, 4, 0.3, 0.7, 1))
Say(f_th(1, 2, 3)) Say(f_ph(1, 2, 3)) Say(f_r(1, 2, 3))
Say(f_agate(1, 2, 3)) Say(f_granite(0.1, 0.2, 0.3)) Say(f_wrinkles(0.1, 0.2, 0.3))
Say(f_snoise3d(0.5, 0.25, 0.75)) Say(f_sine_wave(1, 2, 3)) Say(f_scallop_wave(1, 2, 3))
// expect: 2.74166
// expect: -0.04521
// expect: -0.10000
// expect: 0.39518
// expect: 0.34590
// expect: 0.32582
// expect: 0.11272
// expect: 0.09073
// expect: -0.48280
// expect: 0.32175
// expect: 1.00685
// expect: 3.74166
// expect: 0.95729
// expect: 0.64365
// expect: 0.50099
// expect: -0.23364
// expect: 0.00000
// expect: 0.00000
