// A user function with the wrong number of arguments
// error: 5:14 2
#version 3.7;
#declare F = function(a, b) { a + b }
#declare A = F(1);
