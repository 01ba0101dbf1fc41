// Elements as arguments, whole arrays too
#version 3.7;
#macro Sum(A) #local S = 0; #for (I, 0, dimension_size(A,1)-1) #local S = S + A[I]; #end S #end
#declare Q = array[3] {1,2,3}
#debug concat(str(Sum(Q), 0, 6), "\n") // expect: 6.000000
#declare P = array[2][2] { {1,2},{3,4} }
#macro At(M, I, J) M[I][J] #end
#debug concat(str(At(P, 1, 0), 0, 6), "\n") // expect: 3.000000
