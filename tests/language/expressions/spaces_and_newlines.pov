// An expression may span lines
#version 3.7;
#declare A = 1 +
  2 *
  3
  ;
#debug concat(str(A, 0, 6), "\n") // expect: 7.000000
