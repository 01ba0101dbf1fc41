// More items than the array has places
// error: 4:14
#version 3.7;
#declare A = array[2] { 1, 2, 3 }
