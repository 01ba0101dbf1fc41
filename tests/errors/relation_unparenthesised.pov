// A comparison without parentheses
// error: 4:16
#version 3.7;
#declare A = 1 < 2;
