// an include file as part of a function's body
#version 3.7;
#declare F = function { #include "function_part.inc" }
#debug concat(str(F(1, 2, 3), 0, 0), "\n")
// expect: 5
