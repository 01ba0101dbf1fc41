// An object that is no solid in an intersection warns
// warning: 4:16 intersection
#version 3.7;
intersection { box { 0, 1 } triangle { 0, x, y } }
