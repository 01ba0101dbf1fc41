// Macros of transforms.inc
#version 3.7;
#include "transforms.inc"
#debug concat(vstr(3, vtransform(x, transform{ rotate 90*z translate y }), ",", 0, 6), "\n") // expect: 0.000000,2.000000,0.000000
#debug concat(vstr(3, vinv_transform(x, transform{ rotate 90*z translate y }), ",", 0, 6), "\n") // expect: -1.000000,-1.000000,0.000000
#declare S = sphere{x,1 Rotate_Around_Trans(90*y, 2*x)}
#debug concat(vstr(3, max_extent(S), ",", 0, 6), "\n") // expect: 3.000000,1.000000,2.000000
#declare B = box{0,1 Center_Trans(box{0,1}, x+y)}
#debug concat(vstr(3, max_extent(B), ",", 0, 6), "\n") // expect: 0.500000,0.500000,1.000000
#declare D = cylinder{0,z,0.1 Reorient_Trans(z,y)}
#debug concat(vstr(3, max_extent(D), ",", 0, 6), "\n") // expect: 0.100000,1.000000,0.100000
