// A macro from an include file
#version 3.7;
#include "guarded.inc"
#debug concat(str(Cube_Of(3), 0, 6), "\n") // expect: 27.000000
