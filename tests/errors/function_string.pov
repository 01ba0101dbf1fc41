// A string in a function
// error: 4:25
#version 3.7;
#declare F = function { "text" }
