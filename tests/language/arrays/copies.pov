// Copies are independent
#version 3.7;
#declare A = array[2] {1,2}
#declare B = A;
#declare B[0] = 9;
#debug concat(str(A[0], 0, 6), "\n") // expect: 1.000000
#debug concat(str(B[0], 0, 6), "\n") // expect: 9.000000
