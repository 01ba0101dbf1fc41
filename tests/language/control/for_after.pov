// The loop variable stays, one step beyond the end
#version 3.7;
#for (I, 1, 3) #end
#debug concat(str(I, 0, 6), "\n") // expect: 4.000000
#for (I, 5, 1) #end
#debug concat(str(I, 0, 6), "\n") // expect: 5.000000
#for (I, 1, 9) #if (I=4) #break #end #end
#debug concat(str(I, 0, 6), "\n") // expect: 4.000000
