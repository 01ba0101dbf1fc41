// A name in an expression
// error: 4:18 'B'
#version 3.7;
#declare A = 1 + B;
