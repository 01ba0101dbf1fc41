// Declarations may come before the value
#version 3.7;
#macro Area(W,H) #local R = W*H; R #end
#debug concat(str(Area(3,4), 0, 6), "\n") // expect: 12.000000
#debug concat(str(Area(1,2)+Area(3,4), 0, 6), "\n") // expect: 14.000000
