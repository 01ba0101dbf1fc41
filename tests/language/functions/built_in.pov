// Built-in functions inside functions
#version 3.7;
#declare F = function(a) { sin(a)*cos(a) + atan2(a,2) + pow(a,3) + abs(-a) + floor(a) + mod(a,0.4) }
#debug concat(str(F(1.3), 0, 6), "\n") // expect: 5.431126
#declare G = function(a,b) { max(a,b,2) - min(a,b) + select(a-b,1,2,3) + sqrt(b) + ln(b) + exp(a) }
#debug concat(str(G(1,4), 0, 6), "\n") // expect: 10.104576
#declare H = function(a) { degrees(a) + radians(a) + int(a) + ceil(a) + tanh(a) + asinh(a) }
#debug concat(str(H(0.7), 0, 6), "\n") // expect: 42.376297
