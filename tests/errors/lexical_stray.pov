// A character with no meaning
// error: 4:15
#version 3.7;
sphere { 0, 1 @ }
