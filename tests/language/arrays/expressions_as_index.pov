// Any expression may be an index
#version 3.7;
#declare A = array[4] {10,20,30,40}
#declare I = 1;
#debug concat(str(A[I+1], 0, 6), "\n") // expect: 30.000000
#debug concat(str(A[A[0]/10], 0, 6), "\n") // expect: 20.000000
#debug concat(str(A[min(3,9)], 0, 6), "\n") // expect: 40.000000
