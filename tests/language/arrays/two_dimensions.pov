// Two dimensions with nested initialisers
#version 3.7;
#declare A = array[2][3] { {1,2,3}, {4,5,6} }
#debug concat(str(A[1][2], 0, 6), "\n") // expect: 6.000000
#debug concat(str(A[0][1], 0, 6), "\n") // expect: 2.000000
#debug concat(str(dimensions(A), 0, 6), "\n") // expect: 2.000000
#debug concat(str(dimension_size(A,1), 0, 6), "\n") // expect: 2.000000
#debug concat(str(dimension_size(A,2), 0, 6), "\n") // expect: 3.000000
