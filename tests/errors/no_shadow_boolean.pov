// no_shadow takes no boolean
// error: 4:25
#version 3.7;
sphere { 0, 1 no_shadow off }
