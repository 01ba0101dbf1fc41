// srgb with another working gamma
#version 3.7;
global_settings { assumed_gamma 2.2 }
#declare C2 = srgb 0.5;
#debug concat(vstr(5, C2, ",", 0, 6), "\n") // expect: 0.496227,0.496227,0.496227,0.000000,0.000000
#declare C3 = srgb <0.2,0.5,0.9>;
#debug concat(vstr(5, C3, ",", 0, 6), "\n") // expect: 0.212433,0.496227,0.897055,0.000000,0.000000
