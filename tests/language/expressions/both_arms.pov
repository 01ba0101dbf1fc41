// Both arms of ?: are evaluated
#version 3.7;
#declare N = 0;
#macro Next() #declare N = N + 1; N #end
#declare A = (1 ? Next() : Next());
#debug concat(str(N, 0, 6), "\n") // expect: 2.000000
#debug concat(str(A, 0, 6), "\n") // expect: 1.000000
