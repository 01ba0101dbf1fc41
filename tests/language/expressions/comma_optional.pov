// Vectors need no commas, but 0 -1 subtracts
#version 3.7;
#debug concat(vstr(3, <1 2 3>, ",", 0, 6), "\n") // expect: 1.000000,2.000000,3.000000
#debug concat(vstr(3, <-1 -2, 3>, ",", 0, 6), "\n") // expect: -3.000000,3.000000,0.000000
#debug concat(vstr(3, <1, 2, 3,>, ",", 0, 6), "\n") // expect: 1.000000,2.000000,3.000000
#debug concat(vstr(2, <0 -1, 5>, ",", 0, 6), "\n") // expect: -1.000000,5.000000
