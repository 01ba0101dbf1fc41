// A plane without a direction
// error: 4:9
#version 3.7;
plane { 0, 1 }
