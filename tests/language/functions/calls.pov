// Functions that call functions
#version 3.7;
#declare F = function(a) { a*a }
#declare G = function(a,b) { F(a) + F(b) }
#debug concat(str(G(3,4), 0, 6), "\n") // expect: 25.000000
#declare H = function { G(x, F(y)) - z }
#debug concat(str(H(1,2,3), 0, 6), "\n") // expect: 14.000000
