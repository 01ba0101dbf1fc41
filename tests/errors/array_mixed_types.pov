// Elements of different types
// error: 6:10
#version 3.7;
#declare A = array[2];
#declare A[0] = 1;
#declare A[1] = "text";
