// #for without a variable
// error: 4:7
#version 3.7;
#for (1, 5) #end
