// A string as a condition
// error: 4:6
#version 3.7;
#if ("yes") #end
