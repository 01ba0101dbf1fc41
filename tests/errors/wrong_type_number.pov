// A number where a string belongs
// error: 4:8 string
#version 3.7;
#debug 12
