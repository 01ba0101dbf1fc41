// An array of no elements
// error: 4:20
#version 3.7;
#declare A = array[0];
