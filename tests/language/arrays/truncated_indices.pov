// Sizes and subscripts truncate
#version 3.7;
#declare A = array[1.9];
#declare A[0.9] = 3;
#debug concat(str(dimension_size(A,1), 0, 6), "\n") // expect: 1.000000
#debug concat(str(A[0.99], 0, 6), "\n") // expect: 3.000000
#declare N = array[1][2] { {1,2} }
#debug concat(str(N[0.9][1.99], 0, 6), "\n") // expect: 2.000000
