// An array that grows
// only: minipov
#version 3.8;
#declare A = array;
#declare A[0] = 1;
#declare A[2] = 3;
#debug concat(str(dimension_size(A,1), 0, 6), "\n")
#debug concat(str(A[2], 0, 6), "\n")
// expect: 3.000000
// expect: 3.000000
