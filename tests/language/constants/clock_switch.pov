// The clock given by a switch
// switches: +K0.75
#version 3.7;
#debug concat(str(clock, 0, 6), "\n") // expect: 0.750000
#debug concat(str(clock_on, 0, 6), "\n") // expect: 1.000000
