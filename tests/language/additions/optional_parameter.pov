// Optional macro parameters
// only: minipov
#version 3.8;
#macro M(A, optional B) #ifdef (B) A+B #else A #end #end
#debug concat(str(M(1,2), 0, 6), "\n")
#debug concat(str(M(1,), 0, 6), "\n")
// expect: 3.000000
// expect: 1.000000
