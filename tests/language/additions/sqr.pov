// sqr as a float function
// only: minipov
#version 3.8;
#debug concat(str(sqr(3), 0, 6), "\n")
// expect: 9.000000
