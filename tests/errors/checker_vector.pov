// A vector after a colour is a comparison
// error: 4:55
#version 3.7;
sphere { 0, 1 pigment { checker rgb <1, 0, 0> <0, 1, 0> } }
