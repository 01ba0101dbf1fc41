// A parameter hides a global and even a macro
#version 3.7;
#declare A = 1;
#macro F() 10 #end
#macro G(A, F) A+F #end
#debug concat(str(G(2, 3), 0, 6), "\n") // expect: 5.000000
#debug concat(str(A, 0, 6), "\n") // expect: 1.000000
