// Conditions choose parts of an expression
#version 3.7;
#declare A = 1;
#declare B = (2 * #if (A) 3 #else 4 #end + 1);
#debug concat(str(B, 0, 6), "\n") // expect: 7.000000
