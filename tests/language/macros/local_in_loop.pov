// Locals of a macro called in a loop start anew
#version 3.7;
#macro Count() #ifdef (C) #else #local C = 0; #end #local C = C + 1; C #end
#for (I, 1, 3) #declare R = Count(); #debug concat(str(R,0,0), " ") #end
#debug "\n"

// expect: 1 1 1
