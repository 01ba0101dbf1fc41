// Wire boxes and supercones
#version 3.7;
#include "shapes.inc"
#declare W = object { Wire_Box_Union(<0,0,0>,<2,1,1>,0.1) }
#debug concat(vstr(3, min_extent(W), ",", 0, 6), "\n") // expect: 0.000000,0.000000,0.000000
#debug concat(vstr(3, max_extent(W), ",", 0, 6), "\n") // expect: 2.000000,1.000000,1.000000
#declare T = object { Supertorus(2,0.5,1,1,0.001,1) }
#debug concat(vstr(3, max_extent(T), ",", 0, 6), "\n") // expect: 2.500000,0.500000,2.500000
