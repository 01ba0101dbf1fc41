// The sun's place by date, time and place on earth
#version 3.7;
global_settings { assumed_gamma 1 }
#include "sunpos.inc"
#declare P = SunPos(2000, 6, 21, 12, 2, 0, 51.4667, 0.00);
#debug concat(vstr(3, P/vlength(P), ",", 0, 6), "\n")
#debug concat(str(Az, 0, 4), " ", str(Al, 0, 4), "\n")
#declare P = SunPos(2024, 12, 1, 7, 30, 15, -33.9, 18.4);
#debug concat(vstr(3, P/vlength(P), ",", 0, 6), "\n")
// expect: -0.000670,0.882717,-0.469905
// expect: 180.0817 61.9719
// expect: 0.814571,0.576803,-0.061423
