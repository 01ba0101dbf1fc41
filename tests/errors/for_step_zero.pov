// #for with a step of zero
// error: 4:16 step
#version 3.7;
#for (I, 1, 5, 0) #end
