// Sum of an array in a loop
#version 3.7;
#declare A = array[5] {3,1,4,1,5}
#declare S = 0;
#for (I,0,4) #declare S = S + A[I]; #end
#debug concat(str(S, 0, 6), "\n") // expect: 14.000000
