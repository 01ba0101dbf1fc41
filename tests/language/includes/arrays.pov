// Macros of arrays.inc
#version 3.7;
#include "arrays.inc"
#declare A = array[6] {5,3,9,1,7,2}
Sort_Array(A)
#debug concat(str(A[0], 0, 6), "\n") // expect: 1.000000
#debug concat(str(A[5], 0, 6), "\n") // expect: 9.000000
Reverse_Array(A)
#debug concat(str(A[0], 0, 6), "\n") // expect: 9.000000
#declare R = seed(1);
#debug concat(str(Rand_Array_Item(A, R), 0, 6), "\n") // expect: 5.000000
