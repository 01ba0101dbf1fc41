// A vector that is never closed
// error: 4:22 '>'
#version 3.7;
sphere { <0, 0, 0; 1 }
