// #while without #end
// error: 4:1 #end
#version 3.7;
#while (0)
sphere { 0, 1 }
