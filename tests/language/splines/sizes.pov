// Floats and vectors of two to five components
#version 3.7;
#declare F = spline { 0, 1, 1, 3 }
#debug concat(str(F(0.5).x, 0, 6), "\n") // expect: 2.000000
#declare V = spline { 0, <0,0>, 1, <1,2> }
#debug concat(str(V(0.5).y, 0, 6), "\n") // expect: 1.000000
#declare C = spline { 0, <0,0,0,0,0>, 1, <1,2,3,4,5> }
#debug concat(vstr(5, C(0.5), ",", 0, 6), "\n") // expect: 0.500000,1.000000,1.500000,2.000000,2.500000
