// & and
#version 3.7;
#debug concat(str((1|0&0), 0, 6), "\n") // expect: 0.000000
#debug concat(str((0&0|1), 0, 6), "\n") // expect: 1.000000
#debug concat(str((2 & 3), 0, 6), "\n") // expect: 1.000000
#debug concat(str((0.5 | 0), 0, 6), "\n") // expect: 1.000000
#debug concat(str((!(1&0)), 0, 6), "\n") // expect: 1.000000
#debug concat(str((1=1 & 2=3), 0, 6), "\n") // expect: 0.000000
