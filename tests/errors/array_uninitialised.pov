// An element that was never set
// error: 6:16
#version 3.7;
#declare A = array[3];
#declare A[0] = 1;
#declare B = A[1];
