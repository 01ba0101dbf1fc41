// A triangle whose corners lie on a line
// warning: 4:12 triangle
#version 3.7;
triangle { 0, x, 2*x }
