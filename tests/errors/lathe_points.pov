// A lathe of one point
// error: 4:9 lathe
#version 3.7;
lathe { 1, <0, 0> }
