// #undef removes the innermost binding
#version 3.7;
#declare A = 1;
#undef A
#debug concat(str(defined(A), 0, 6), "\n") // expect: 0.000000
#macro M() #local B = 2; #undef B defined(B) #end
#declare B = 1;
#debug concat(str(M(), 0, 6), "\n") // expect: 1.000000
