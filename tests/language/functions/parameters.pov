// Functions with named parameters
#version 3.7;
#declare F = function(a, b) { a*10 + b }
#debug concat(str(F(1,2), 0, 6), "\n") // expect: 12.000000
#declare G = function(x) { x*x }
#debug concat(str(G(3), 0, 6), "\n") // expect: 9.000000
#declare H = function(u, v) { u-v }
#debug concat(str(H(5,3), 0, 6), "\n") // expect: 2.000000
