// Functions of x, y and z
#version 3.7;
#declare F = function { x*x + 2*y - z }
#debug concat(str(F(1,2,3), 0, 6), "\n") // expect: 2.000000
#debug concat(str(F(0.5,0,0), 0, 6), "\n") // expect: 0.250000
