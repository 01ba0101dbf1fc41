// Signs in functions
#version 3.7;
#declare F = function(a) { -a*2 + -3 }
#debug concat(str(F(1), 0, 6), "\n") // expect: -5.000000
#declare G = function(a) { +a - -a }
#debug concat(str(G(2), 0, 6), "\n") // expect: 4.000000
