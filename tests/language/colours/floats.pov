// A float fills what the form asks for
#version 3.7;
#declare C0 = rgb 0.4;
#debug concat(vstr(5, C0, ",", 0, 6), "\n") // expect: 0.400000,0.400000,0.400000,0.000000,0.000000
#declare C1 = rgbf 0.4;
#debug concat(vstr(5, C1, ",", 0, 6), "\n") // expect: 0.400000,0.400000,0.400000,0.400000,0.000000
#declare C2 = rgbt 0.4;
#debug concat(vstr(5, C2, ",", 0, 6), "\n") // expect: 0.400000,0.400000,0.400000,0.000000,0.400000
#declare C3 = rgbft 0.4;
#debug concat(vstr(5, C3, ",", 0, 6), "\n") // expect: 0.400000,0.400000,0.400000,0.400000,0.400000
#declare C4 = color 0.4;
#debug concat(vstr(5, C4, ",", 0, 6), "\n") // expect: 0.400000,0.400000,0.400000,0.400000,0.400000
