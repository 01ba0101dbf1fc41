// #write of floats, vectors and strings
#version 3.7;
#fopen Out "written.txt" write
#write (Out, 1/3, " ", 1234567.891, ",", <1,2.5,-3>, "|", 1e-7, " ", 12, "\n")
#fclose Out
#fopen In "written.txt" read
#read (In, A)
#fclose In
#debug concat(str(A, 0, 6), "\n") // expect: 0.333333
