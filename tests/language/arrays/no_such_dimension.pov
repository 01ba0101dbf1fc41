// the size of a dimension that an array does not have
#version 3.7;
#declare A = array[2][3];
#debug concat(str(dimension_size(A, 2), 0, 0), str(dimension_size(A, 3), 0, 0), str(dimension_size(A, 0), 0, 0), "\n")
// expect: 300
