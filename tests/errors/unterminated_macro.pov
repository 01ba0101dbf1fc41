// #macro without #end
// error: 5:1 '#macro' is never closed
// hint: #end
#version 3.7;
#macro M(A)
sphere { 0, A }
