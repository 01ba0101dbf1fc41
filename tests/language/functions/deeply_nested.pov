// a function nested 300 deep
#version 3.7;
#declare S = "x";
#declare I = 0;
#fopen H "nested.inc" write
#write (H, "#declare F = function { ")
#while (I < 300) #write (H, "(1+") #declare I = I + 1; #end
#write (H, "x")
#while (I > 0) #write (H, ")") #declare I = I - 1; #end
#write (H, " }\n")
#fclose H
#include "nested.inc"
#debug concat(str(F(2, 0, 0), 0, 0), "\n")
// expect: 302
