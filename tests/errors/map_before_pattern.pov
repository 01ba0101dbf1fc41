// A colour map before its pattern
// error: 4:59
#version 3.7;
sphere { 0, 1 pigment { color_map { [0 rgb 0] [1 rgb 1] } gradient x } }
