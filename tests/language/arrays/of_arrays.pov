// Arrays of arrays
#version 3.7;
#declare A = array[2];
#declare A[0] = array[2] {1,2}
#declare A[1] = array[3] {3,4,5}
#debug concat(str(A[1][1], 0, 6), "\n") // expect: 4.000000
#debug concat(str(A[0][1], 0, 6), "\n") // expect: 2.000000
#debug concat(str(dimension_size(A[1],1), 0, 6), "\n") // expect: 3.000000
