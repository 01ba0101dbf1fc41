// #while without #end
// error: 5:1 '#while' is never closed
// hint: #end
#version 3.7;
#while (0)
sphere { 0, 1 }
