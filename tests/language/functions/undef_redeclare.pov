// A function may be declared again after #undef
#version 3.7;
#declare F = function { x }
#debug concat(str(F(3,0,0), 0, 6), "\n") // expect: 3.000000
#undef F
#declare F = function { x*2 }
#debug concat(str(F(3,0,0), 0, 6), "\n") // expect: 6.000000
