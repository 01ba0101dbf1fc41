// #undef of an element
#version 3.7;
#declare A = array[2] {1,2}
#undef A[1]
#debug concat(str(defined(A[1]), 0, 6), "\n") // expect: 0.000000
#debug concat(str(A[0], 0, 6), "\n") // expect: 1.000000
