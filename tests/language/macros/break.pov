// #break leaves a macro
#version 3.7;
#macro M(A) #if (A) 1 #break #end 2 #end
#debug concat(str(M(1), 0, 6), "\n") // expect: 1.000000
#debug concat(str(M(0), 0, 6), "\n") // expect: 2.000000
