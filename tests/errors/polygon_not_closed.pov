// A polygon that does not close
// warning: 4:11 polygon
#version 3.7;
polygon { 3, <0, 0>, <1, 0>, <1, 1> }
