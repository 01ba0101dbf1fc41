// Shape functions of functions.inc
#version 3.7;
#include "functions.inc"
#debug concat(str(f_sphere(1,2,3,0.5), 0, 6), "\n") // expect: 3.241657
#debug concat(str(f_torus(1,0.2,0.3,0.8,0.2), 0, 6), "\n") // expect: 0.115517
#debug concat(str(f_rounded_box(0.9,0.8,0.7,0.1,1,1,1), 0, 6), "\n") // expect: -0.100001
#debug concat(str(f_superellipsoid(0.5,0.5,0.5,0.5,0.8), 0, 6), "\n") // expect: 0.273803
#debug concat(str(f_heart(0.1,0.2,0.3,-1), 0, 6), "\n") // expect: -0.615232
#debug concat(str(f_helix1(0.1,0.2,0.3,2,5,0.3,0.6,1,1,0), 0, 6), "\n") // expect: 0.014528
#debug concat(str(f_mesh1(0.1,0.2,0.3,1,1,0.1,0.2,1), 0, 6), "\n") // expect: 0.031557
#debug concat(str(f_r(1,2,2), 0, 6), "\n") // expect: 3.000000
#debug concat(str(f_th(1,0,1), 0, 6), "\n") // expect: 0.785398
#debug concat(str(f_ph(1,1,0), 0, 6), "\n") // expect: 0.785398
