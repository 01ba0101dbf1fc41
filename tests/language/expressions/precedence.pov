// Multiplication before addition, left to right
#version 3.7;
#debug concat(str(2+3*4, 0, 6), "\n") // expect: 14.000000
#debug concat(str(10-4-3, 0, 6), "\n") // expect: 3.000000
#debug concat(str(12/4/3, 0, 6), "\n") // expect: 1.000000
#debug concat(str(2*3-4*5, 0, 6), "\n") // expect: -14.000000
#debug concat(str((2+3)*4, 0, 6), "\n") // expect: 20.000000
