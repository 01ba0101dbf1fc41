// The bounds are evaluated once
#version 3.7;
#declare N = 3;
#for (I, 1, N) #declare N = 10; #end
#debug concat(str(I, 0, 6), "\n") // expect: 4.000000
