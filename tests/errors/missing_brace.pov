// A brace that is never closed
// error: 4:1 }
#version 3.7;
sphere { 0, 1 pigment { rgb 1 }
