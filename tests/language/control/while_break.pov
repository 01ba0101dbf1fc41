// #break leaves a loop
#version 3.7;
#declare I = 0;
#while (1)
  #declare I = I + 1;
  #if (I = 5) #break #end
#end
#debug concat(str(I, 0, 6), "\n") // expect: 5.000000
