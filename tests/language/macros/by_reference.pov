// A lone identifier is passed by reference
#version 3.7;
#macro Set(P) #declare P = 7; #end
#declare G = 1;
Set(G)
#debug concat(str(G, 0, 6), "\n") // expect: 7.000000
