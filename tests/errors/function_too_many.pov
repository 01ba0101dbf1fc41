// Too many arguments of a built-in function
// error: 4:17
#version 3.7;
#declare A = sin(2, 3);
