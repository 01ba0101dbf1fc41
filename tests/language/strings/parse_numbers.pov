// Building text in a loop
#version 3.7;
#declare S = "";
#for (I, 1, 5) #declare S = concat(S, str(I,-3,0), #if (I < 5) "," #else "" #end) #end
#debug concat(S, "\n") // expect: 001,002,003,004,005
