// ?: in a function
// error: 4:27
#version 3.7;
#declare F = function { x ? 1 : 2 }
