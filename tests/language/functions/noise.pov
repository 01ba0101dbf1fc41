// Noise functions of the include file
#version 3.7;
#include "functions.inc"
#debug concat(str(f_noise3d(0.1,0.2,0.3), 0, 6), "\n") // expect: 0.417192
#debug concat(str(f_noise_generator(0.1,0.2,0.3,1), 0, 6), "\n") // expect: 0.299243
#debug concat(str(f_noise_generator(0.1,0.2,0.3,3), 0, 6), "\n") // expect: 0.652261
#debug concat(str(f_snoise3d(0.1,0.2,0.3), 0, 6), "\n") // expect: -0.165616
#debug concat(str(f_ridged_mf(0.1,0.2,0.3,0.1,3,7,0.7,0.7,2), 0, 6), "\n") // expect: 0.337107
