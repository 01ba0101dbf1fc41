// Up to five dimensions
#version 3.7;
#declare A = array[2][1][2][1][2];
#declare A[1][0][1][0][1] = 7;
#debug concat(str(A[1][0][1][0][1], 0, 6), "\n") // expect: 7.000000
#debug concat(str(dimensions(A), 0, 6), "\n") // expect: 5.000000
