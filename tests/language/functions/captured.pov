// Identifiers are captured when the function is declared
#version 3.7;
#declare K = 5;
#declare F = function(a) { a*K }
#declare K = 100;
#debug concat(str(F(2), 0, 6), "\n") // expect: 10.000000
