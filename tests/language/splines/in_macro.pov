// A spline as an argument
#version 3.7;
#macro At(S, T) S(T) #end
#declare L = spline { linear_spline 0,<1,0,0> 1,<2,0,0> }
#debug concat(str(At(L, 0.25).x, 0, 6), "\n") // expect: 1.250000
