// The square root of a negative number
// error: 4:14 sqrt
#version 3.7;
#declare A = sqrt(-1);
