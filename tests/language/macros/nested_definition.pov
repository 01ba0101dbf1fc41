// A macro defined by a macro
#version 3.7;
#macro Make() #macro Made() 42 #end #end
Make()
#debug concat(str(Made(), 0, 6), "\n") // expect: 42.000000
