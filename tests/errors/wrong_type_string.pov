// A string where a number belongs
// error: 4:13 string
#version 3.7;
sphere { 0, "one" }
