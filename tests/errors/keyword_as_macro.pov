// A reserved word as the name of a macro
// error: 4:8 'box'
#version 3.7;
#macro box(A) A #end
