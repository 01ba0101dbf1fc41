// Arrays passed to macros by reference
#version 3.7;
#macro Fill(A) #for (I,0,dimension_size(A,1)-1) #declare A[I] = I*I; #end #end
#declare Q = array[4];
Fill(Q)
#debug concat(str(Q[3], 0, 6), "\n") // expect: 9.000000
