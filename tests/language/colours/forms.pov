// rgb, rgbf, rgbt and rgbft
#version 3.7;
#declare C0 = rgb <1,0.5,0.25>;
#debug concat(vstr(5, C0, ",", 0, 6), "\n") // expect: 1.000000,0.500000,0.250000,0.000000,0.000000
#declare C1 = rgbf <1,0.5,0.25,0.1>;
#debug concat(vstr(5, C1, ",", 0, 6), "\n") // expect: 1.000000,0.500000,0.250000,0.100000,0.000000
#declare C2 = rgbt <1,0.5,0.25,0.2>;
#debug concat(vstr(5, C2, ",", 0, 6), "\n") // expect: 1.000000,0.500000,0.250000,0.000000,0.200000
#declare C3 = rgbft <1,0.5,0.25,0.1,0.2>;
#debug concat(vstr(5, C3, ",", 0, 6), "\n") // expect: 1.000000,0.500000,0.250000,0.100000,0.200000
