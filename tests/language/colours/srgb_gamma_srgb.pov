// srgb where the working gamma is sRGB too
#version 3.7;
global_settings { assumed_gamma srgb }
#declare C2 = srgb <0.2,0.5,0.9>;
#debug concat(vstr(5, C2, ",", 0, 6), "\n") // expect: 0.200000,0.500000,0.900000,0.000000,0.000000
