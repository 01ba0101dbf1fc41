// A colour map without entries
// error: 4:44 color_map
#version 3.7;
sphere { 0, 1 pigment { marble color_map { } } }
