// Colours of colors.inc
#version 3.7;
#include "colors.inc"
#debug concat(vstr(5, Red, ",", 0, 6), "\n") // expect: 1.000000,0.000000,0.000000,0.000000,0.000000
#debug concat(vstr(5, NeonPink, ",", 0, 6), "\n") // expect: 1.000000,0.430000,0.780000,0.000000,0.000000
#debug concat(vstr(5, Clear, ",", 0, 6), "\n") // expect: 1.000000,1.000000,1.000000,1.000000,0.000000
#debug concat(vstr(5, Gray50, ",", 0, 6), "\n") // expect: 0.500000,0.500000,0.500000,0.000000,0.000000
#debug concat(vstr(5, White*0.5, ",", 0, 6), "\n") // expect: 0.500000,0.500000,0.500000,0.000000,0.000000
