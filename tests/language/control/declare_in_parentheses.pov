// Directives inside a parenthesised expression
#version 3.7;
#declare A = (3 #if (1) +4 #end);
#debug concat(str(A, 0, 6), "\n") // expect: 7.000000
#declare B = (#for (I,1,4) I + #end 0);
#debug concat(str(B, 0, 6), "\n") // expect: 10.000000
