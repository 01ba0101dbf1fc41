// A subscript beyond the end
// error: 5:16 3
#version 3.7;
#declare A = array[3] { 1, 2, 3 }
#declare B = A[3];
