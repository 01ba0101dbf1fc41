// A number with two dots
// error: 4:14 '1.5.x'
#version 3.7;
#declare A = 1.5.x;
