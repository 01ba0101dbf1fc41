// #while evaluates its condition each time
#version 3.7;
#declare I = 0;
#while (I < 3)
  #debug concat(str(I,0,0), " ")
  #declare I = I + 1;
#end
#debug "\n"
#debug concat(str(I, 0, 6), "\n")

// expect: 0 1 2
// expect: 3.000000
