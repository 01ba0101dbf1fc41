// A macro sees the locals of its caller
#version 3.7;
#macro Inner() L*2 #end
#macro Outer() #local L = 21; Inner() #end
#debug concat(str(Outer(), 0, 6), "\n") // expect: 42.000000
