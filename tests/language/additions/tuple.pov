// Several names at once
// only: minipov
#version 3.7;
#declare (A,B) = (1,2);
#debug concat(str(A, 0, 6), "\n")
#debug concat(str(B, 0, 6), "\n")
// expect: 1.000000
// expect: 2.000000
