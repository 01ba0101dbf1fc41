// An item that a light does not have
// error: 4:21 pigment
#version 3.7;
light_source { 0, 1 pigment { rgb 1 } }
