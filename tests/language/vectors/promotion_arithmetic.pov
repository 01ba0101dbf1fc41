// The shorter operand is promoted; floats fill every component
#version 3.7;
#debug concat(vstr(3, <1,2>*<3,4,5>, ",", 0, 6), "\n") // expect: 3.000000,8.000000,0.000000
#debug concat(vstr(4, x+t, ",", 0, 6), "\n") // expect: 1.000000,0.000000,0.000000,1.000000
#debug concat(vstr(3, 5*x+1, ",", 0, 6), "\n") // expect: 6.000000,1.000000,1.000000
#debug concat(vstr(3, <1,2,3>-4, ",", 0, 6), "\n") // expect: -3.000000,-2.000000,-1.000000
#debug concat(vstr(4, <1,2>+<1,2,3,4>, ",", 0, 6), "\n") // expect: 2.000000,4.000000,3.000000,4.000000
#debug concat(vstr(3, u+z, ",", 0, 6), "\n") // expect: 1.000000,0.000000,1.000000
