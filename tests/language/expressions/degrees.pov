// degrees and radians
#version 3.7;
#debug concat(str(degrees(pi), 0, 6), "\n") // expect: 180.000000
#debug concat(str(radians(180), 0, 6), "\n") // expect: 3.141593
#debug concat(str(degrees(1), 0, 6), "\n") // expect: 57.295780
