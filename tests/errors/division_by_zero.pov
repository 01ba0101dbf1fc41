// A division by zero only warns
// warning: 4:14 zero
#version 3.7;
#declare A = 1/0;
