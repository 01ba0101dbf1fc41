// A function of one argument takes every operator
#version 3.7;
#debug concat(str(abs(1<2), 0, 6), "\n") // expect: 1.000000
#debug concat(str(abs(1<2&0), 0, 6), "\n") // expect: 0.000000
#debug concat(str(sqrt(1?9:4), 0, 6), "\n") // expect: 3.000000
#debug concat(str(int(3.7 = 3.7), 0, 6), "\n") // expect: 1.000000
