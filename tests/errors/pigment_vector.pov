// A pigment of a vector without rgb
// error: 4:25
#version 3.7;
sphere { 0, 1 pigment { <1, 0, 0> } }
