// alpha is the old name of filter
#version 3.7;
#declare C = color red 1 alpha 0.3;
#debug concat(vstr(5, C, ",", 0, 6), "\n") // expect: 1.000000,0.000000,0.000000,0.300000,0.000000
