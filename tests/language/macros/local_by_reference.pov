// #local on a parameter overwrites the caller's variable too
#version 3.7;
#macro Set(P) #local P = 99; #end
#declare G = 1;
Set(G)
#debug concat(str(G, 0, 6), "\n") // expect: 99.000000
