// points of fewer terms: a number stands for two, the rest is as in the point before
#version 3.7;
#declare S = spline { linear_spline 0, <1, 2, 3> 1, <4, 5> 2, 7 }
#debug concat(vstr(3, S(1), ",", 0, 2), " ", vstr(3, S(2), ",", 0, 2), "\n")
#declare S = spline { linear_spline 0, 1 1, <4, 5> 2, <7, 8, 9> }
#debug concat(vstr(3, S(0), ",", 0, 2), " ", vstr(3, S(1), ",", 0, 2), "\n")
#declare S = spline { linear_spline 2, x 1, 2 0, <4, 5, 6, 7, 8> }
#debug concat(vstr(5, S(0), ",", 0, 2), " ", vstr(5, S(1), ",", 0, 2), "\n")
// expect: 4.00,5.00,3.00 7.00,7.00,3.00
// expect: 1.00,1.00,0.00 4.00,5.00,0.00
// expect: 4.00,5.00,6.00,7.00,8.00 2.00,2.00,0.00,0.00,0.00
