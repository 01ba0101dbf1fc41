// trace() of a number
// error: 5:14
#version 3.7;
#declare N = 5;
#declare A = trace(N, 0, x);
