// A number with two dots
// error: 4:17
#version 3.7;
#declare A = 1.5.x;
