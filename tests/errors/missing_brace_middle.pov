// A block that runs into the next one
// error: 4:15
#version 3.7;
sphere { 0, 1 pigment { rgb 1
box { 0, 1 }
