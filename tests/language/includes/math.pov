// Macros of math.inc
#version 3.7;
#include "math.inc"
#debug concat(str(sind(30), 0, 6), "\n") // expect: 0.500000
#debug concat(str(cosd(60), 0, 6), "\n") // expect: 0.500000
#debug concat(str(tand(45), 0, 6), "\n") // expect: 1.000000
#debug concat(str(Interpolate(0.5,0,1,10,20,1), 0, 6), "\n") // expect: 15.000000
#debug concat(str(clip(5,0,1), 0, 6), "\n") // expect: 1.000000
#debug concat(str(clamp(5.3,0,2), 0, 6), "\n") // expect: 1.300000
#debug concat(str(adj_range(0.5,10,20), 0, 6), "\n") // expect: 15.000000
#debug concat(str(even(4), 0, 6), "\n") // expect: 1.000000
#debug concat(str(odd(3), 0, 6), "\n") // expect: 1.000000
#debug concat(str(sgn(-2), 0, 6), "\n") // expect: -1.000000
