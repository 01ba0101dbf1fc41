// #else without #if
// error: 4:1 #else
#version 3.7;
#else
sphere { 0, 1 }
