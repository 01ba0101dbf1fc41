// min and max of many arguments
#version 3.7;
#debug concat(str(max(1,5,3), 0, 6), "\n") // expect: 5.000000
#debug concat(str(min(4,2,8,-1), 0, 6), "\n") // expect: -1.000000
#debug concat(str(max(2,2), 0, 6), "\n") // expect: 2.000000
#debug concat(str(min(1.5,1.25), 0, 6), "\n") // expect: 1.250000
