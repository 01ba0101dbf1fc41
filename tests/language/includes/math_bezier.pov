// Comparison macros of math.inc
#version 3.7;
#include "math.inc"
#debug concat(str(VEq(<1,2,3>,<1,2,3>), 0, 6), "\n") // expect: 1.000000
#debug concat(str(VZero(0*x), 0, 6), "\n") // expect: 1.000000
#debug concat(str(VMin(<3,1,2>), 0, 6), "\n") // expect: 1.000000
#debug concat(str(VMax(<3,1,2>), 0, 6), "\n") // expect: 3.000000
#debug concat(vstr(3, VPow(<1,2,3>,2), ",", 0, 6), "\n") // expect: 1.000000,4.000000,9.000000
#debug concat(vstr(3, VPerp_To_Plane(x,y), ",", 0, 6), "\n") // expect: 0.000000,0.000000,1.000000
#debug concat(str(VAngle(x,x+y), 0, 6), "\n") // expect: 0.785398
