// Identifiers given by Declare
// switches: Declare=Speed=2.5 Declare=Other=-3
#version 3.7;
#debug concat(str(Speed, 0, 6), "\n") // expect: 2.500000
#debug concat(str(Other, 0, 6), "\n") // expect: -3.000000
#debug concat(str(Speed*2, 0, 6), "\n") // expect: 5.000000
