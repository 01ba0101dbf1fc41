// version as a number
#version 3.7;
#debug concat(str(version, 0, 6), "\n") // expect: 3.700000
