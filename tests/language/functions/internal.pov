// Internal functions by number
#version 3.7;
#declare F = function { internal(61) }
#debug concat(str(F(1,0,0,1), 0, 6), "\n") // expect: 0.000000
#debug concat(str(F(3,0,0,2), 0, 6), "\n") // expect: 1.000000
#declare R = function { internal(57) }
#debug concat(str(R(3,4,0), 0, 6), "\n") // expect: 5.000000
#declare N = function { internal(76) }
#debug concat(str(N(0.1,0.2,0.3), 0, 6), "\n") // expect: 0.417192
