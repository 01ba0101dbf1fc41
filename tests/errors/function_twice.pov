// A function declared twice
// error: 5:10 'F'
#version 3.7;
#declare F = function { x }
#declare F = function { y };
