// append adds to a file
#version 3.7;
#fopen Out "app.txt" write
#write (Out, "1,")
#fclose Out
#fopen Out "app.txt" append
#write (Out, "2,")
#fclose Out
#fopen In "app.txt" read
#read (In, A, B)
#debug concat(str(A+B*10, 0, 6), "\n") // expect: 21.000000
#fclose In
