// Macros expand inside a function
#version 3.7;
#macro Square(A) ((A)*(A)) #end
#declare F = function { Square(2) + x }
#debug concat(str(F(1,0,0), 0, 6), "\n")
#macro Wave(F) sin(x*F) // the body's own comment
#end
#declare K = 3;
#declare G = function { Wave(3)*2 + Wave(K) }
#debug concat(str(G(0.3,0,0), 0, 6), "\n")
#macro Half(V) V/2 #end
#declare H = function(a, x) { Half(4) + x*a }
#debug concat(str(H(2,5), 0, 6), "\n")
// expect: 5.000000
// expect: 2.349981
// expect: 12.000000
