// Constants of consts.inc
#version 3.7;
#include "consts.inc"
#debug concat(str(Diamond_Ior, 0, 6), "\n") // expect: 2.470000
#debug concat(str(Crown_Glass_Ior, 0, 6), "\n") // expect: 1.510000
#debug concat(str(e, 0, 6), "\n") // expect: 2.718282
#debug concat(vstr(3, o, ",", 0, 6), "\n") // expect: 0.000000,0.000000,0.000000
#debug concat(vstr(3, xz, ",", 0, 6), "\n") // expect: 1.000000,0.000000,1.000000
