// Anything but a lone identifier is passed by value
#version 3.7;
#macro Set(P) #declare P = 7; #end
#declare G = 1;
Set(G+0)
Set(+G)
Set((G))
#debug concat(str(G, 0, 6), "\n") // expect: 1.000000
