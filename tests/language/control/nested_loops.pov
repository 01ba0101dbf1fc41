// Loops within loops
#version 3.7;
#for (I, 1, 3)
  #for (J, 1, I) #debug concat(str(I*J,0,0)," ") #end
#end
#debug "\n"

// expect: 1 2 4 3 6 9
