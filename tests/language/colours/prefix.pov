// color and colour are optional
#version 3.7;
#declare A = color rgb x;
#declare B = colour rgb x;
#declare C = rgb x;
#debug concat(vstr(5, A, ",", 0, 6), "\n") // expect: 1.000000,0.000000,0.000000,0.000000,0.000000
#debug concat(vstr(5, B, ",", 0, 6), "\n") // expect: 1.000000,0.000000,0.000000,0.000000,0.000000
#debug concat(vstr(5, C, ",", 0, 6), "\n") // expect: 1.000000,0.000000,0.000000,0.000000,0.000000
