// Derivatives of functions by math.inc
#version 3.7;
#include "math.inc"
#declare F = function { x*x + 3*y - z*z*z }
#debug concat(vstr(3, vGradient(F, <1,2,3>), ",", 0, 6), "\n") // expect: 2.000000,3.000000,-27.000001
#declare G = fn_Gradient(F)
#debug concat(str(G(1,2,3), 0, 6), "\n") // expect: 27.239678
#declare D = fn_Gradient_Directional(F, <0,1,0>)
#debug concat(str(D(1,2,3), 0, 6), "\n") // expect: 3.000000
