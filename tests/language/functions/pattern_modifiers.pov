// Transforms, waves and turbulence in a pattern function
#version 3.7;
#declare F = function { pattern { onion scallop_wave frequency 2 phase 0.3 scale 0.7 rotate <10,20,30> translate <1,2,3> } }
#debug concat(str(F(0.3,0.4,0.5), 0, 6), "\n") // expect: 0.041158
#declare G = function { pattern { gradient x turbulence 0.5 octaves 3 omega 0.7 lambda 3 } }
#debug concat(str(G(0.3,0.4,0.5), 0, 6), "\n") // expect: 0.246434
#declare H = function { pattern { gradient y warp { turbulence <0.2,0.3,0.1> } poly_wave 2 } }
#debug concat(str(H(0.3,0.4,0.5), 0, 6), "\n") // expect: 0.112099
#declare I = function { pattern { crackle form <1,0.5,0.2> metric 3 offset 0.4 } }
#debug concat(str(I(0.3,0.4,0.5), 0, 6), "\n") // expect: 1.000000
