// A pigment function gives a colour
#version 3.7;
#declare P = function { pigment { gradient x color_map { [0 rgb 0] [1 rgbt <1,0.5,0.25,0.75>] } } }
#debug concat(vstr(5, P(0.5,0,0), ",", 0, 6), "\n") // expect: 0.500000,0.250000,0.125000,0.000000,0.375000
#debug concat(str(P(0.25,0,0).red, 0, 6), "\n") // expect: 0.250000
#debug concat(str(P(0.25,0,0).transmit, 0, 6), "\n") // expect: 0.187500
