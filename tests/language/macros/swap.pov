// Swap two variables by reference
#version 3.7;
#macro Swap(A,B) #local T = A; #declare A = B; #declare B = T; #end
#declare P = 1; #declare Q = 2;
Swap(P,Q)
#debug concat(str(P, 0, 6), "\n") // expect: 2.000000
#debug concat(str(Q, 0, 6), "\n") // expect: 1.000000
