// Patterns as functions
#version 3.7;
#declare F = function { pattern { gradient x triangle_wave } }
#debug concat(str(F(0.1,0,0), 0, 6), "\n") // expect: 0.200000
#debug concat(str(F(1.7,0,0), 0, 6), "\n") // expect: 0.600000
#declare G = function { pattern { checker } }
#debug concat(str(G(0.5,0.5,0.5), 0, 6), "\n") // expect: 0.000000
#debug concat(str(G(1.5,0.5,0.5), 0, 6), "\n") // expect: 1.000000
#declare H = function { pattern { hexagon } }
#debug concat(str(H(0.1,0,1.9), 0, 6), "\n") // expect: 1.000000
