// Division by zero warns and gives infinity
#version 3.7;
#declare A = 1/0;
#debug concat(str(A, 0, 6), "\n") // expect: inf
#declare B = -1/0;
#debug concat(str(B, 0, 6), "\n") // expect: inf
