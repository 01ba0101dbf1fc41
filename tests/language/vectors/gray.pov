// gray weighs red, green and blue
#version 3.7;
#declare C = rgb <1,0.5,0.25>;
#debug concat(str(C.gray, 0, 6), "\n") // expect: 0.620000
#debug concat(str(<1,0.5,0.25>.gray, 0, 6), "\n") // expect: 0.620000
#debug concat(str(x.gray, 0, 6), "\n") // expect: 0.297000
#debug concat(str(<1,1,1,1,1>.gray, 0, 6), "\n") // expect: 1.000000
