// Too few arguments of a built-in function
// error: 4:14
#version 3.7;
#declare A = pow(2);
