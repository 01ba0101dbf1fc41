// Vectors of four and five components
#version 3.7;
#debug concat(vstr(5, <1,2,3,4,5>*2, ",", 0, 6), "\n") // expect: 2.000000,4.000000,6.000000,8.000000,10.000000
#debug concat(vstr(4, <1,2,3,4>+1, ",", 0, 6), "\n") // expect: 2.000000,3.000000,4.000000,5.000000
#debug concat(vstr(5, <1,2>+<0,0,0,0,9>, ",", 0, 6), "\n") // expect: 1.000000,2.000000,0.000000,0.000000,9.000000
