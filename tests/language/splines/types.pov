// Each type halfway
#version 3.7;
#declare L = spline { linear_spline 0,<0,0,0> 1,<1,2,3> 2,<0,0,0> }
#declare Q = spline { quadratic_spline 0,<0,0,0> 1,<1,2,3> 2,<0,0,0> }
#declare N = spline { natural_spline 0,<0,0,0> 1,<1,2,3> 2,<0,0,0> }
#declare C = spline { cubic_spline -1,<0,0,-1> 0,<1,0,0> 1,<0,0,1> 2,<-1,0,0> }
#debug concat(vstr(3, L(0.5), ",", 0, 6), "\n") // expect: 0.500000,1.000000,1.500000
#debug concat(vstr(3, Q(0.5), ",", 0, 6), "\n") // expect: 0.750000,1.500000,2.250000
#debug concat(vstr(3, N(0.5), ",", 0, 6), "\n") // expect: 0.687500,1.375000,2.062500
#debug concat(vstr(3, C(0.5), ",", 0, 6), "\n") // expect: 0.625000,0.000000,0.625000
