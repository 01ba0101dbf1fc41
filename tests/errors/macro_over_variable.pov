// A macro with the name of a variable
// error: 5:1
#version 3.7;
#declare A = 1;
#macro A() 1 #end
