// pow(0, 0)
// error: 4:14 pow
#version 3.7;
#declare A = pow(0, 0);
