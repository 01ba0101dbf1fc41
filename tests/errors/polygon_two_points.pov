// A polygon of two points
// error: 4:11
#version 3.7;
polygon { 2, <0, 0>, <1, 0> }
