// Streams are independent and numbered
#version 3.7;
#declare A = seed(1);
#declare B = seed(1);
#debug concat(str(A, 0, 6), "\n") // expect: 0.000000
#debug concat(str(B, 0, 6), "\n") // expect: 1.000000
#debug concat(str(rand(A), 0, 6), "\n") // expect: 0.421993
#debug concat(str(rand(B), 0, 6), "\n") // expect: 0.421993
#debug concat(str(rand(A), 0, 6), "\n") // expect: 0.487121
#debug concat(str(rand(B), 0, 6), "\n") // expect: 0.487121
