// A condition without parentheses
// error: 4:5 (
#version 3.7;
#if 1 = 1 #end
