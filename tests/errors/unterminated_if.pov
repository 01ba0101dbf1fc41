// #if without #end
// error: 4:1 #end
#version 3.7;
#if (1)
sphere { 0, 1 }
