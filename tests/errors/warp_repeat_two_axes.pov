// A repeat along two axes
// error: 4:47 repeat
#version 3.7;
sphere { 0, 1 pigment { checker warp { repeat <1, 1, 0> } } }
