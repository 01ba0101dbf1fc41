// Trigonometric functions in radians
#version 3.7;
#debug concat(str(sin(1), 0, 6), "\n") // expect: 0.841471
#debug concat(str(cos(1), 0, 6), "\n") // expect: 0.540302
#debug concat(str(tan(1), 0, 6), "\n") // expect: 1.557408
#debug concat(str(asin(0.5), 0, 6), "\n") // expect: 0.523599
#debug concat(str(acos(0.5), 0, 6), "\n") // expect: 1.047198
#debug concat(str(atan(2), 0, 6), "\n") // expect: 1.107149
#debug concat(str(atan2(1,-1), 0, 6), "\n") // expect: 2.356194
#debug concat(str(atan2(-1,0), 0, 6), "\n") // expect: -1.570796
