// Points are sorted; an equal parameter replaces
#version 3.7;
#declare S = spline { 2,<20,0,0> 0,<0,0,0> 1,<99,0,0> 1,<10,0,0> }
#debug concat(vstr(3, S(0.5), ",", 0, 6), "\n") // expect: 5.000000,0.000000,0.000000
#debug concat(vstr(3, S(1.5), ",", 0, 6), "\n") // expect: 15.000000,0.000000,0.000000
