// #local at top level is like #declare
#version 3.7;
#local A = 4;
#debug concat(str(A, 0, 6), "\n") // expect: 4.000000
#declare A = 5;
#debug concat(str(A, 0, 6), "\n") // expect: 5.000000
