// Pigments as functions, by component
#version 3.7;
#declare P = function { pigment { bozo color_map { [0 rgb x] [1 rgb <0,1,0.5>] } scale 0.5 } }
#debug concat(str(P(0.1,0.2,0.3).red, 0, 6), "\n") // expect: 0.489043
#debug concat(str(P(0.1,0.2,0.3).green, 0, 6), "\n") // expect: 0.510957
#debug concat(str(P(0.1,0.2,0.3).gray, 0, 6), "\n") // expect: 0.475324
#declare F = function { P(x,y,z).blue*2 }
#debug concat(str(F(0.1,0.2,0.3), 0, 6), "\n") // expect: 0.510957
