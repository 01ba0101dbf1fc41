// The end has a slack of 1e-10
#version 3.7;
#declare C = 0;
#for (I, 0, 1, 0.1) #declare C = C + 1; #end
#debug concat(str(C, 0, 6), "\n") // expect: 11.000000
