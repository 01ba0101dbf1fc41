// A patterned texture as a layer
// error: 4:45 layer
#version 3.7;
sphere { 0, 1 texture { pigment { rgb 1 } } texture { checker texture { pigment { rgb 0 } }, texture { pigment { rgb 1 } } } }
