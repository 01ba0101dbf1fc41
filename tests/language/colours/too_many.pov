// rgb with four components keeps the fourth as filter
#version 3.7;
#declare C0 = rgb <1,2,3,4>;
#debug concat(vstr(5, C0, ",", 0, 6), "\n") // expect: 1.000000,2.000000,3.000000,4.000000,0.000000
#declare C1 = rgb <1,2,3,4,5>;
#debug concat(vstr(5, C1, ",", 0, 6), "\n") // expect: 1.000000,2.000000,3.000000,4.000000,5.000000
#declare C2 = rgbf <1,2,3>;
#debug concat(vstr(5, C2, ",", 0, 6), "\n") // expect: 1.000000,2.000000,3.000000,0.000000,0.000000
#declare C3 = rgbt <1,2,3>;
#debug concat(vstr(5, C3, ",", 0, 6), "\n") // expect: 1.000000,2.000000,3.000000,0.000000,0.000000
#declare C4 = rgbt <1,2,3,4,5>;
#debug concat(vstr(5, C4, ",", 0, 6), "\n") // expect: 1.000000,2.000000,3.000000,0.000000,4.000000
#declare C5 = rgbft <1,2,3>;
#debug concat(vstr(5, C5, ",", 0, 6), "\n") // expect: 1.000000,2.000000,3.000000,0.000000,0.000000
#declare C6 = color <1,2,3,4,5>;
#debug concat(vstr(5, C6, ",", 0, 6), "\n") // expect: 1.000000,2.000000,3.000000,4.000000,5.000000
#declare C7 = color <1,2>;
#debug concat(vstr(5, C7, ",", 0, 6), "\n") // expect: 1.000000,2.000000,0.000000,0.000000,0.000000
