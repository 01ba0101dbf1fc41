// Pattern functions of functions.inc
#version 3.7;
#include "functions.inc"
#debug concat(str(f_agate(0.1,0.2,0.3), 0, 6), "\n") // expect: 0.223695
#debug concat(str(f_bozo(0.1,0.2,0.3), 0, 6), "\n") // expect: 0.417192
#debug concat(str(f_granite(0.1,0.2,0.3), 0, 6), "\n") // expect: 0.643654
#debug concat(str(f_marble(0.1,0.2,0.3), 0, 6), "\n") // expect: 0.200000
#debug concat(str(f_crackle(0.1,0.2,0.3), 0, 6), "\n") // expect: 0.102800
#debug concat(str(f_leopard(0.1,0.2,0.3), 0, 6), "\n") // expect: 0.039207
#debug concat(str(f_sine_wave(0.4,2,3), 0, 6), "\n") // expect: -1.175571
#debug concat(str(f_scallop_wave(0.4,2,3), 0, 6), "\n") // expect: 1.175571
