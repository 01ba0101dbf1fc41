// Comments between tokens
#version 3.7;
#declare /* a */ A /* b */ = // c
  3 /* d */ ;
#debug concat(str(A, 0, 6), "\n") // expect: 3.000000
