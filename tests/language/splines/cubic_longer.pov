// A longer cubic and a natural spline
#version 3.7;
#declare C = spline { cubic_spline 0,<0,0,0> 1,<1,0,2> 2.5,<2,3,0> 3,<1,1,1> 4,<0,0,0> }
#debug concat(vstr(3, C(1.3), ",", 0, 6), "\n") // expect: 1.296000,0.552000,1.840000
#debug concat(vstr(3, C(2.7), ",", 0, 6), "\n") // expect: 1.672000,2.344000,0.352000
#declare N = spline { natural_spline 0,1 1,2 2,1 3,0 }
#debug concat(str(N(0.5).x, 0, 6), "\n") // expect: 1.700000
#debug concat(str(N(2.2).x, 0, 6), "\n") // expect: 0.761600
#declare Q = spline { quadratic_spline 0,0 1,1 2,4 3,9 4,16 }
#debug concat(str(Q(0.5).x, 0, 6), "\n") // expect: 0.250000
#debug concat(str(Q(2.5).x, 0, 6), "\n") // expect: 6.250000
