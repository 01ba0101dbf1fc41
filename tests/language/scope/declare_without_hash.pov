// declare without # at top level
#version 3.7;
declare A = 1;
#debug concat(str(A, 0, 6), "\n") // expect: 1.000000
