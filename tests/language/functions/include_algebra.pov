// More internal surfaces
#version 3.7;
#include "functions.inc"
#debug concat(str(f_algbr_cyl1(0.3,0.4,0.5,1,0.5,0,0,1), 0, 6), "\n") // expect: 0.097000
#debug concat(str(f_bifolia(0.3,0.4,0.5,1,0.5), 0, 6), "\n") // expect: -0.182000
#debug concat(str(f_boy_surface(0.3,0.4,0.5,1,1), 0, 6), "\n") // expect: -10.000000
#debug concat(str(f_devils_curve(0.3,0.4,0.5,1), 0, 6), "\n") // expect: -0.097600
#debug concat(str(f_dupin_cyclid(0.3,0.4,0.5,1,0.4,0.3,0.2,0.1,0.5), 0, 6), "\n") // expect: 0.002344
#debug concat(str(f_enneper(0.3,0.4,0.5,1), 0, 6), "\n") // expect: 0.005371
#debug concat(str(f_flange_cover(0.3,0.4,0.5,1,0.5,0.4,0.3), 0, 6), "\n") // expect: -0.634561
#debug concat(str(f_glob(0.3,0.4,0.5,1), 0, 6), "\n") // expect: -0.404735
#debug concat(str(f_hyperbolic_torus(0.3,0.4,0.5,1,0.5,0.2), 0, 6), "\n") // expect: -0.204100
#debug concat(str(f_klein_bottle(0.3,0.4,0.5,1), 0, 6), "\n") // expect: 3.213000
#debug concat(str(f_kummer_surface_v1(0.3,0.4,0.5,1), 0, 6), "\n") // expect: -0.519300
#debug concat(str(f_nodal_cubic(0.3,0.4,0.5,1), 0, 6), "\n") // expect: 1.011000
#debug concat(str(f_paraboloid(0.3,0.4,0.5,1), 0, 6), "\n") // expect: 0.060000
#debug concat(str(f_piriform(0.3,0.4,0.5,1), 0, 6), "\n") // expect: 0.391100
#debug concat(str(f_quantum(0.3,0.4,0.5,1), 0, 6), "\n") // expect: 1.199751
#debug concat(str(f_steiners_roman(0.3,0.4,0.5,1), 0, 6), "\n") // expect: -0.136900
#debug concat(str(f_strophoid(0.3,0.4,0.5,1,0.5,0.2,0.3), 0, 6), "\n") // expect: 0.047480
#debug concat(str(f_torus_gumdrop(0.3,0.4,0.5,1), 0, 6), "\n") // expect: -8.332100
#debug concat(str(f_umbrella(0.3,0.4,0.5,1), 0, 6), "\n") // expect: 0.010000
#debug concat(str(f_witch_of_agnesi(0.3,0.4,0.5,1,0.5), 0, 6), "\n") // expect: 0.164000
