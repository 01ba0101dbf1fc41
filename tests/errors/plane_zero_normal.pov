// A plane without a direction
// error: 4:1
#version 3.7;
plane { 0, 1 }
