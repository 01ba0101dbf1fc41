// Shapes of shapes.inc by their extents
#version 3.7;
#include "shapes.inc"
#declare B = object { Round_Box_Union(<-1,-1,-1>,<1,2,3>,0.25) }
#debug concat(vstr(3, min_extent(B), ",", 0, 6), "\n") // expect: -1.000000,-1.000000,-1.000000
#debug concat(vstr(3, max_extent(B), ",", 0, 6), "\n") // expect: 1.000000,2.000000,3.000000
#declare C = object { Round_Cylinder_Union(<0,0,0>,<0,2,0>,1,0.25) }
#debug concat(vstr(3, max_extent(C), ",", 0, 6), "\n") // expect: 1.000000,2.000000,1.000000
#declare W = object { Wedge(30) }
#debug concat(vstr(3, max_extent(W), ",", 0, 6), "\n") // expect: 10000000000.000000,10000000000.000000,10000000000.000000
#declare S = object { Spheroid(<1,2,3>,<1,2,1>) }
#debug concat(vstr(3, max_extent(S), ",", 0, 6), "\n") // expect: 2.000000,4.000000,4.000000
