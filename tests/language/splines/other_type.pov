// A spline evaluated as another type
#version 3.7;
#declare S = spline { linear_spline 0,<0,0,0> 1,<1,2,3> 2,<0,0,0> }
#debug concat(vstr(3, S(0.5, quadratic_spline), ",", 0, 6), "\n") // expect: 0.750000,1.500000,2.250000
#debug concat(vstr(3, S(0.5, natural_spline), ",", 0, 6), "\n") // expect: 0.687500,1.375000,2.062500
