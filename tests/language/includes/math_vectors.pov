// Vector macros of math.inc
#version 3.7;
#include "math.inc"
#debug concat(vstr(3, VProject_Plane(<1,2,3>,y), ",", 0, 6), "\n") // expect: 1.000000,0.000000,3.000000
#debug concat(vstr(3, VProject_Axis(<1,2,3>,y), ",", 0, 6), "\n") // expect: 0.000000,2.000000,0.000000
#debug concat(vstr(3, VPerp_To_Vector(x), ",", 0, 6), "\n") // expect: 0.000000,-1.000000,0.000000
#debug concat(vstr(3, VPerp_Adjust(<1,1,0>,x), ",", 0, 6), "\n") // expect: 0.000000,1.000000,0.000000
#debug concat(str(VAngleD(x,y), 0, 6), "\n") // expect: 90.000000
#debug concat(str(VDist(<1,2,3>,<4,6,3>), 0, 6), "\n") // expect: 5.000000
#debug concat(str(VRotationD(x,y,z), 0, 6), "\n") // expect: 90.000000
#debug concat(vstr(3, VWith_Len(<3,0,4>,10), ",", 0, 6), "\n") // expect: 6.000000,0.000000,8.000000
