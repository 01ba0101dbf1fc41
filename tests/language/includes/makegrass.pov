// A blade of grass, bent
#version 3.7;
global_settings { assumed_gamma 1 }
#include "makegrass.inc"
#declare Blade = mesh { MakeBlade(false, <0, 0, 0>, 0, 5, 10, 1, 0.1, 0.5, <0, 1, 0.3>, <0, 0, 1>, 3, true, false) }
#debug concat(vstr(3, min_extent(Blade), ",", 0, 4), " ", vstr(3, max_extent(Blade), ",", 0, 4), "\n")
// expect: -1.0000,0.0000,0.0000 1.0000,9.9908,5.8762
