// Negative and fractional seeds
#version 3.7;
#declare A = seed(-5);
#debug concat(str(rand(A), 0, 6), "\n") // expect: 0.890053
#declare B = seed(3.9);
#debug concat(str(rand(B), 0, 6), "\n") // expect: 0.265973
#declare C = seed(3);
#debug concat(str(rand(C), 0, 6), "\n") // expect: 0.265973
