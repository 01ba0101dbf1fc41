// Binary words up to the next comma
#version 3.7;
#fopen Out "binary.txt" write
#write (Out, uint8 34 65 66 34, ",", uint8 <53,44,10>)
#fclose Out
#fopen In "binary.txt" read
#read (In, S, N)
#fclose In
#debug concat(S, "\n") // expect: AB
#debug concat(str(N, 0, 6), "\n") // expect: 5.000000
