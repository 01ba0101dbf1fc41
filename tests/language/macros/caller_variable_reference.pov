// A parameter handed on stays a reference
#version 3.7;
#macro Inner(P) #declare P = P + 1; #end
#macro Outer(Q) Inner(Q) Inner(Q) #end
#declare N = 5;
Outer(N)
#debug concat(str(N, 0, 6), "\n") // expect: 7.000000
