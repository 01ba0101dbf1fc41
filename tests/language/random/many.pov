// The thousandth value
#version 3.7;
#declare R = seed(7);
#for (I, 1, 999) #local D = rand(R); #end
#debug concat(str(rand(R), 0, 6), "\n") // expect: 0.001417
