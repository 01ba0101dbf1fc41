// interior_texture without a texture
// error: 4:15 interior_texture
#version 3.7;
sphere { 0, 1 interior_texture { pigment { rgb 1 } } }
