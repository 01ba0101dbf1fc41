// A prism of two points
// error: 4:15 prism
#version 3.7;
prism { 0, 1, 2, <0, 0>, <1, 1> }
