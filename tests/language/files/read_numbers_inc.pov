// Reading a file that comes with the scene
#version 3.7;
#fopen In "numbers.txt" read
#read (In, A, B, V, S)
#debug concat(str(A, 0, 6), "\n") // expect: 12.500000
#debug concat(str(B, 0, 6), "\n") // expect: -3.000000
#debug concat(vstr(3, V, ",", 0, 6), "\n") // expect: 1.000000,2.000000,3.000000
#debug concat(S, "\n") // expect: a word
#debug concat(str(defined(In), 0, 6), "\n") // expect: 0.000000
#fclose In
