// A division by zero only warns
// warning: 4:15 zero
#version 3.7;
#declare A = 1/0;
