// The logo and the letters built of solids
#version 3.7;
global_settings { assumed_gamma 1 }
#include "logo.inc"
#include "chars.inc"
#debug concat(vstr(3, min_extent(char_A), ",", 0, 3), " ", vstr(3, max_extent(char_A), ",", 0, 3), "\n")
#debug concat(vstr(3, min_extent(char_Z), ",", 0, 3), " ", vstr(3, max_extent(char_Z), ",", 0, 3), "\n")
#debug concat(str(inside(char_H, <0, 2, 0>), 0, 0), str(inside(Povray_Logo, <0, 0, 0>), 2, 0), "\n")
object { Povray_Logo_Prism scale 2 }
object { char_B pigment { rgb 1 } }
// expect: -2.000,0.000,0.000 2.000,5.000,1.000
// expect: -2.000,0.000,0.000 2.000,5.000,1.000
// expect: 1 1
