// defined and #ifdef of an element
#version 3.7;
#declare A = array[2];
#declare A[1] = 1;
#debug concat(str(defined(A[0]), 0, 6), "\n")
#debug concat(str(defined(A[1]), 0, 6), "\n")

// expect: 0.000000
// expect: 1.000000
