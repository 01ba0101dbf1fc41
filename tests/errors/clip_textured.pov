// A clipping object with a texture
// error: 4:15
#version 3.7;
sphere { 0, 1 clipped_by { box { 0, 1 pigment { rgb 1 } } } }
