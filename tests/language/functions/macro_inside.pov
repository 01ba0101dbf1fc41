// Macros expand inside a function
#version 3.7;
#macro Square(A) ((A)*(A)) #end
#declare F = function { Square(2) + x }
#debug concat(str(F(1,0,0), 0, 6), "\n") // expect: 5.000000
