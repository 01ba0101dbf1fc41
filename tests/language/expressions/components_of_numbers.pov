// a number has the first component
#version 3.7;
#declare A = 3;
#debug concat(str(A.x, 0, 2), " ", str(A.u, 0, 2), " ", str(A.red, 0, 2), " ", str((A + 2).x, 0, 2), "\n")
#debug concat(str(vlength(<1, 2, 2>).x, 0, 2), "\n")
// expect: 3.00 3.00 3.00 5.00
// expect: 3.00
