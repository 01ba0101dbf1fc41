// A macro body may call a macro defined later
#version 3.7;
#macro First() Later()*2 #end
#macro Later() 4 #end
#debug concat(str(First(), 0, 6), "\n") // expect: 8.000000
