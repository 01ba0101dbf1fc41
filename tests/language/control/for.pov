// #for counts inclusively
#version 3.7;
#for (I, 1, 3) #debug concat(str(I,0,0), " ") #end
#for (I, 5, 1, -2) #debug concat(str(I,0,0), " ") #end
#for (I, 0, 1, 0.25) #debug concat(str(I,0,2), " ") #end
#debug "\n"

// expect: 1 2 3 5 3 1 0.00 0.25 0.50 0.75 1.00
