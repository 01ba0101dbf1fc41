// After rgb every operator is allowed
#version 3.7;
#declare C = rgb x<y;
#debug concat(vstr(3, C, ",", 0, 6), "\n") // expect: 0.000000,1.000000,0.000000
