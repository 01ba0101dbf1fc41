// An object where a number belongs
// error: 5:13 object
#version 3.7;
#declare Ball = sphere { 0, 1 }
sphere { 0, Ball }
