// Splines as functions
#version 3.7;
#declare S = function { spline { linear_spline 0, <0,0,0>, 1, <2,4,6> } }
#debug concat(vstr(3, S(0.5), ",", 0, 6), "\n") // expect: 1.000000,2.000000,3.000000
#debug concat(str(S(0.25).y, 0, 6), "\n") // expect: 1.000000
#declare F = function(t0) { S(t0).x + S(t0).z }
#debug concat(str(F(0.5), 0, 6), "\n") // expect: 4.000000
