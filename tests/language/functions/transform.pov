// Transforms as functions
#version 3.7;
#declare T = function { transform { rotate 90*z translate x } }
#debug concat(vstr(3, T(1,0,0), ",", 0, 6), "\n") // expect: 1.000000,1.000000,0.000000
#declare I = function { transform { rotate 90*z translate x inverse } }
#debug concat(vstr(3, I(1,1,0), ",", 0, 6), "\n") // expect: 1.000000,0.000000,0.000000
#declare F = function { T(x,y,z).y }
#debug concat(str(F(3,0,0), 0, 6), "\n") // expect: 3.000000
