// Bitwise functions of two and more arguments
#version 3.7;
#debug concat(str(bitwise_and(12,10), 0, 6), "\n") // expect: 8.000000
#debug concat(str(bitwise_or(12,10), 0, 6), "\n") // expect: 14.000000
#debug concat(str(bitwise_xor(12,10), 0, 6), "\n") // expect: 6.000000
#debug concat(str(bitwise_and(255,60,24), 0, 6), "\n") // expect: 24.000000
#debug concat(str(bitwise_or(1,2,4), 0, 6), "\n") // expect: 7.000000
#debug concat(str(bitwise_xor(7.9,2), 0, 6), "\n") // expect: 5.000000
