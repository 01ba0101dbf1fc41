// A sphere without a radius
// error: 4:20
#version 3.7;
sphere { <0, 0, 0> }
