// srgb decodes to the working gamma
#version 3.7;
global_settings { assumed_gamma 1 }
#declare C2 = srgb 0.5;
#debug concat(vstr(5, C2, ",", 0, 6), "\n") // expect: 0.214041,0.214041,0.214041,0.000000,0.000000
#declare C3 = srgb <0.2,0.5,1>;
#debug concat(vstr(5, C3, ",", 0, 6), "\n") // expect: 0.033105,0.214041,1.000000,0.000000,0.000000
#declare C4 = srgbf <0.2,0.5,1,0.3>;
#debug concat(vstr(5, C4, ",", 0, 6), "\n") // expect: 0.033105,0.214041,1.000000,0.300000,0.000000
#declare C5 = srgbt <0.2,0.5,1,0.3>;
#debug concat(vstr(5, C5, ",", 0, 6), "\n") // expect: 0.033105,0.214041,1.000000,0.000000,0.300000
#declare C6 = srgbft <0.2,0.5,1,0.3,0.4>;
#debug concat(vstr(5, C6, ",", 0, 6), "\n") // expect: 0.033105,0.214041,1.000000,0.300000,0.400000
#declare C7 = srgb <0.02,0.04045,0.05>;
#debug concat(vstr(5, C7, ",", 0, 6), "\n") // expect: 0.001548,0.003131,0.003936,0.000000,0.000000
#declare C8 = srgb <1.4,-0.5,0>;
#debug concat(vstr(5, C8, ",", 0, 6), "\n") // expect: 2.163044,-0.038700,0.000000,0.000000,0.000000
