// Functions as arguments of a macro loop
#version 3.7;
#declare F = function(i) { i*i - 1 }
#declare S = 0;
#for (I, 1, 4) #declare S = S + F(I); #end
#debug concat(str(S, 0, 6), "\n") // expect: 26.000000
