// #elseif chains
#version 3.7;
#macro Kind(N) #if (N<0) "negative" #elseif (N=0) "zero" #elseif (N<10) "small" #else "big" #end #end
#debug concat(Kind(-3), "\n") // expect: negative
#debug concat(Kind(0), "\n") // expect: zero
#debug concat(Kind(5), "\n") // expect: small
#debug concat(Kind(50), "\n") // expect: big
