// A reserved word as a parameter
// error: 4:10
#version 3.7;
#macro M(color) 1 #end
