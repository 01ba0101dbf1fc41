// #macro without #end
// error: 4:1 #end
#version 3.7;
#macro M(A)
sphere { 0, A }
