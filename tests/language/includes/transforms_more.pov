// Axis rotation, shear, matrix and alignment of transforms.inc
#version 3.7;
#include "transforms.inc"
#declare F = function { transform { Axis_Rotate_Trans(<1,1,1>,120) } }
#debug concat(vstr(3, F(1,2,3), ",", 0, 6), "\n") // expect: 3.000000,1.000000,2.000000
#declare G = function { transform { Shear_Trans(x, y+0.5*x, z) } }
#debug concat(vstr(3, G(1,2,3), ",", 0, 6), "\n") // expect: 2.000000,2.000000,3.000000
#declare H = function { transform { Matrix_Trans(y,z,x,<1,1,1>) } }
#debug concat(vstr(3, H(1,2,3), ",", 0, 6), "\n") // expect: 4.000000,2.000000,3.000000
#declare I = function { transform { Point_At_Trans(<1,1,1>) } }
#debug concat(vstr(3, I(0,1,0), ",", 0, 6), "\n") // expect: 0.577350,0.577350,0.577350
#declare B = box{0,1 Align_Trans(box{0,1},-y,<0,5,0>)}
#debug concat(vstr(3, min_extent(B), ",", 0, 6), "\n") // expect: 0.000000,5.000000,0.000000
