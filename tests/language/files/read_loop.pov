// A loop reads until the handle is undefined
#version 3.7;
#fopen Out "loop.txt" write
#for (I, 1, 4) #write (Out, I*I, ",\n") #end
#fclose Out
#fopen In "loop.txt" read
#declare Sum = 0; #declare N = 0;
#while (defined(In))
  #read (In, Item)
  #declare Sum = Sum + Item; #declare N = N + 1;
#end
#debug concat(str(N, 0, 6), "\n") // expect: 5.000000
#debug concat(str(Sum, 0, 6), "\n") // expect: 46.000000
