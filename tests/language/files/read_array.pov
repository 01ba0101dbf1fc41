// #read into array elements that have a value
#version 3.7;
#declare A = array[3] {0,0,0}
#fopen In "numbers.txt" read
#read (In, A[0], A[1])
#fclose In
#debug concat(str(A[0]+A[1], 0, 6), "\n") // expect: 9.500000
