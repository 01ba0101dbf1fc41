// Outside its range a spline gives the nearest value
#version 3.7;
#declare L = spline { linear_spline 0,<1,0,0> 1,<2,0,0> }
#debug concat(vstr(3, L(-1), ",", 0, 6), "\n") // expect: 1.000000,0.000000,0.000000
#debug concat(vstr(3, L(5), ",", 0, 6), "\n") // expect: 2.000000,0.000000,0.000000
#declare C = spline { cubic_spline -1,<0,0,-1> 0,<1,0,0> 1,<0,0,1> 2,<-1,0,0> }
#debug concat(vstr(3, C(-0.5), ",", 0, 6), "\n") // expect: 1.000000,0.000000,0.000000
#debug concat(vstr(3, C(1.5), ",", 0, 6), "\n") // expect: 0.000000,0.000000,1.000000
