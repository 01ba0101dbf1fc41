// An array whose size comes from its items
// only: minipov
#version 3.8;
#declare A = array { 1, 2, 3 }
#debug concat(str(dimension_size(A,1), 0, 6), "\n")
// expect: 3.000000
