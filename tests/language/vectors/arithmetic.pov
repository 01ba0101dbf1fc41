// Arithmetic by component
#version 3.7;
#debug concat(vstr(3, <1,2,3>+<4,5,6>, ",", 0, 6), "\n") // expect: 5.000000,7.000000,9.000000
#debug concat(vstr(3, <1,2,3>*<4,5,6>, ",", 0, 6), "\n") // expect: 4.000000,10.000000,18.000000
#debug concat(vstr(3, 2*<1,2,3>, ",", 0, 6), "\n") // expect: 2.000000,4.000000,6.000000
#debug concat(vstr(3, <1,2,3>-1, ",", 0, 6), "\n") // expect: 0.000000,1.000000,2.000000
#debug concat(vstr(3, -<1,2,3>, ",", 0, 6), "\n") // expect: -1.000000,-2.000000,-3.000000
#debug concat(vstr(3, <1,2,3>/2, ",", 0, 6), "\n") // expect: 0.500000,1.000000,1.500000
