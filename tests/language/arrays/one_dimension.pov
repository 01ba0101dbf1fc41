// An array filled by index
#version 3.7;
#declare A = array[3];
#declare A[0] = 5;
#declare A[1] = A[0]*2;
#declare A[2] = A[1]+A[0];
#debug concat(str(A[2], 0, 6), "\n") // expect: 15.000000
#debug concat(str(dimension_size(A,1), 0, 6), "\n") // expect: 3.000000
#debug concat(str(dimensions(A), 0, 6), "\n") // expect: 1.000000
