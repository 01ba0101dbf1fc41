// trace and vector built-ins inside expressions
#version 3.7;
#declare F = function { pigment { rgb <0.25,0.5,1> } }
#declare C = F(0,0,0);
#debug concat(vstr(5, C, ",", 0, 6), "\n") // expect: 0.250000,0.500000,1.000000,0.000000,0.000000
