// An element passed by reference
#version 3.7;
#macro Double(E) #declare E = E*2; #end
#declare A = array[2] {3,4}
Double(A[1])
#debug concat(str(A[0], 0, 6), "\n") // expect: 3.000000
#debug concat(str(A[1], 0, 6), "\n") // expect: 8.000000
