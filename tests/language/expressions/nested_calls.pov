// Calls inside calls
#version 3.7;
#debug concat(str(max(min(3,4),abs(-2)), 0, 6), "\n") // expect: 3.000000
#debug concat(str(sqrt(pow(3,2)+pow(4,2)), 0, 6), "\n") // expect: 5.000000
#debug concat(str(vlength(<sin(pi/2),cos(0),0>), 0, 6), "\n") // expect: 1.414214
