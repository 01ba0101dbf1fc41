// An array of no elements
// error: 4:14
#version 3.7;
#declare A = array[0];
