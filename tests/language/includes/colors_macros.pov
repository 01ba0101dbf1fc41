// Colour spaces of colors.inc
#version 3.7;
#include "colors.inc"
#debug concat(vstr(5, CHSL2RGB(<120,1,0.5>), ",", 0, 6), "\n") // expect: 0.000000,1.000000,0.000000,0.000000,0.000000
#debug concat(vstr(5, CRGB2HSL(<0.2,0.4,0.6>), ",", 0, 6), "\n") // expect: 210.000001,0.500000,0.400000,0.000000,0.000000
#debug concat(vstr(5, CHSV2RGB(<200,0.5,0.8>), ",", 0, 6), "\n") // expect: 0.400000,0.666667,0.800000,0.000000,0.000000
#debug concat(vstr(5, CRGB2HSV(<0.2,0.4,0.6>), ",", 0, 6), "\n") // expect: 210.000001,0.666667,0.600000,0.000000,0.000000
