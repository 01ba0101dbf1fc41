// #if without #end
// error: 5:1 '#if' is never closed
// hint: #end
#version 3.7;
#if (1)
sphere { 0, 1 }
