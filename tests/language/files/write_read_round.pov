// Values written with commas are read back
#version 3.7;
#fopen Out "round.txt" write
#write (Out, 1.5, ",", <1,2,3>, ",", "\"text\"", ",", -4, "\n")
#fclose Out
#fopen In "round.txt" read
#read (In, A, V, S, B)
#fclose In
#debug concat(str(A, 0, 6), "\n") // expect: 1.500000
#debug concat(vstr(3, V, ",", 0, 6), "\n") // expect: 1.000000,2.000000,3.000000
#debug concat(S, "\n") // expect: text
#debug concat(str(B, 0, 6), "\n") // expect: -4.000000
