// A subscript after what is no array
// error: 5:16
#version 3.7;
#declare A = 5;
#declare B = A[0];
