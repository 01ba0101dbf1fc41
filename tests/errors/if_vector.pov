// A vector as a condition
// error: 4:6 vector
#version 3.7;
#if (<1, 2, 3>) #end
