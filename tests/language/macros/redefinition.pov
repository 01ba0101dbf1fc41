// The last definition wins
#version 3.7;
#macro M() 1 #end
#debug concat(str(M(), 0, 6), "\n") // expect: 1.000000
#macro M() 2 #end
#debug concat(str(M(), 0, 6), "\n") // expect: 2.000000
