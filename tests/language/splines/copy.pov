// A copy with another point
#version 3.7;
#declare A = spline { linear_spline 0,<0,0,0> 1,<1,1,1> }
#declare B = spline { A 2,<9,9,9> }
#debug concat(vstr(3, B(1.5), ",", 0, 6), "\n") // expect: 5.000000,5.000000,5.000000
#debug concat(vstr(3, A(1.5), ",", 0, 6), "\n") // expect: 1.000000,1.000000,1.000000
