// A declaration in a macro does not disturb a pending sum
#version 3.7;
#macro Next(N) #declare K = N; K*2 #end
#declare T = 1 + Next(5);
#debug concat(str(T, 0, 6), "\n") // expect: 11.000000
#debug concat(str(K, 0, 6), "\n") // expect: 5.000000
