// Initialisers, with a trailing comma
#version 3.7;
#declare A = array[3] {1,2,3}
#declare B = array[2] {4,5,}
#debug concat(str(A[0]+A[2], 0, 6), "\n") // expect: 4.000000
#debug concat(str(B[1], 0, 6), "\n") // expect: 5.000000
