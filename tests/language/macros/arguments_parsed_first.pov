// An argument is a value before the call
#version 3.7;
#macro Ret(A) A*2 #end
#debug concat(str(Ret(1+2), 0, 6), "\n") // expect: 6.000000
