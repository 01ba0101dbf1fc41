// #break leaves only the innermost loop
#version 3.7;
#for (I, 1, 3) #for (J, 1, 9) #if (J > I) #break #end #debug concat(str(J,0,0)," ") #end #end
#debug "\n"

// expect: 1 1 2 1 2 3
