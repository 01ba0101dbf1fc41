// A scale of zero in one direction
// warning: 4:21 scale
#version 3.7;
sphere { 0, 1 scale <1, 0, 1> }
