// A local array shadows the global one
#version 3.7;
#declare A = array[1] {1}
#macro M() #local A = array[1] {2}; A[0] #end
#debug concat(str(M(), 0, 6), "\n") // expect: 2.000000
#debug concat(str(A[0], 0, 6), "\n") // expect: 1.000000
