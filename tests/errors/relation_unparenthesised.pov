// A comparison without parentheses
// error: 5:16 '<'
// hint: parentheses
#version 3.7;
#declare A = 1 < 2;
