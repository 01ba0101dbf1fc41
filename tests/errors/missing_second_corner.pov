// A box without its second corner
// error: 4:9
#version 3.7;
box { 0 pigment { rgb 1 } }
