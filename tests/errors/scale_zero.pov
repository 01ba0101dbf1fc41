// A scale of zero in one direction
// warning: 4:15 scale
#version 3.7;
sphere { 0, 1 scale <1, 0, 1> }
