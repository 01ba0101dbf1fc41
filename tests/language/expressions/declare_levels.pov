// A declaration takes comparisons only in parentheses
#version 3.7;
#declare A = (1 < 2);
#declare B = (2 = 3 | 1 > 0);
#debug concat(str(A, 0, 6), "\n") // expect: 1.000000
#debug concat(str(B, 0, 6), "\n") // expect: 1.000000
