// A patterned texture as the default
// error: 4:12
#version 3.7;
#default { texture { checker texture { pigment { rgb 0 } }, texture { pigment { rgb 1 } } } }
