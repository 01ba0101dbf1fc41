// Large and small numbers through str
#version 3.7;
#debug concat(str(1e10, 0, 6), "\n") // expect: 10000000000.000000
#debug concat(str(123456789.123, 0, 6), "\n") // expect: 123456789.123000
#debug concat(str(1e-7, 0, 6), "\n") // expect: 0.000000
#debug concat(str(1/3*3, 0, 6), "\n") // expect: 1.000000
