// The loop variable may be changed in the body
#version 3.7;
#for (I, 1, 10) #debug concat(str(I,0,0)," ") #declare I = I + 2; #end
#debug "\n"

// expect: 1 4 7 10
