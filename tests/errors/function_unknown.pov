// An unknown name in a function
// error: 4:29 'q'
#version 3.7;
#declare F = function { x + q }
