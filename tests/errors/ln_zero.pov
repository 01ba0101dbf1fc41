// The logarithm of zero
// error: 4:14 ln
#version 3.7;
#declare A = ln(0);
