// Blanks keep >= apart from the end of a vector
#version 3.7;
#debug concat(vstr(3, (<1,2,3> = <3,2,1>), ",", 0, 6), "\n") // expect: 0.000000,1.000000,0.000000
#debug concat(vstr(3, (<1,2,3> >= <3,2,1>), ",", 0, 6), "\n") // expect: 0.000000,1.000000,1.000000
